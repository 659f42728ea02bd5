//! How much of a settings file may be compiled: globs with wildcards take a hundred times the memory of their text, and
//! each of them is tried on each path.

/// Most characters that all globs with wildcards of a file have together: some hundreds of them. Plain paths and names
/// of rules are looked up and need no room.
const MOST: usize = 5_000;

/// What the globs of a file have taken so far.
#[derive(Debug, Default)]
pub(super) struct Room {
    taken: usize,
}

impl Room {
    /// Takes room for a glob. If it is the one that does not fit, says so and what to do.
    pub(super) fn take(&mut self, characters: usize) -> Option<(String, String)> {
        let before = self.is_full();
        self.taken = self.taken.saturating_add(characters);
        (self.is_full() && !before).then(|| {
            let message = format!("the globs up to this one have more than {MOST} characters in total");
            let help = "use names without wildcards, which do not count, or a baseline for known findings";
            (message, help.to_owned())
        })
    }

    /// Whether no more is compiled.
    pub(super) const fn is_full(&self) -> bool {
        self.taken > MOST
    }
}
