//! Bugs of ours, kept from taking everything else with them.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Does some work; if it panics, notes in `failed` what it was.
pub(super) fn caught<T, W>(
    what: impl Into<W>,
    failed: &mut Vec<W>,
    work: impl FnOnce() -> T,
) -> Option<T> {
    let done = catch_unwind(AssertUnwindSafe(work)).ok();
    if done.is_none() {
        failed.push(what.into());
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_that_panics_is_named_and_the_rest_goes_on() {
        let mut failed: Vec<String> = Vec::new();
        let half = |number: i32| {
            if number % 2 == 0 {
                number / 2
            } else {
                panic!("odd")
            }
        };
        let halves = [2, 3, 4]
            .map(|number| caught(format!("half of {number}"), &mut failed, || half(number)));
        assert_eq!(halves, [Some(1), None, Some(2)]);
        assert_eq!(failed, ["half of 3"]);
    }
}
