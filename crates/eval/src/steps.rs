//! Steps of work, counted in tests: a bound on them holds on every machine, one on time on none.

#[cfg(test)]
thread_local! {
    static TAKEN: std::cell::Cell<u64> = const { std::cell::Cell::new(0) };
}

/// Takes a step of work that could become too much.
#[inline]
pub fn step() {
    #[cfg(test)]
    TAKEN.set(TAKEN.get() + 1);
}

/// Steps that something takes on this thread.
#[cfg(test)]
pub fn steps_of(work: impl FnOnce()) -> u64 {
    let before = TAKEN.get();
    work();
    TAKEN.get() - before
}
