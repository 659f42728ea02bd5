//! Remembers for each path and rule whether globs match. Many findings ask the same about one file,
//! and to try all globs again each time is slow.

use std::cell::RefCell;
use std::collections::HashMap;

/// The answers so far, for each path and rule.
pub(super) struct Answered<T> {
    known: RefCell<HashMap<String, Vec<(&'static str, T)>>>,
}

impl<T> Default for Answered<T> {
    fn default() -> Self {
        Self {
            known: RefCell::default(),
        }
    }
}

impl<T: Copy> Answered<T> {
    /// The answer for a path and a rule. `answer` is called only the first time.
    pub(super) fn of(&self, path: &str, rule: &'static str, answer: impl FnOnce() -> T) -> T {
        if let Some(known) = self.known(path, rule) {
            return known;
        }
        let new = answer();
        let mut known = self.known.borrow_mut();
        match known.get_mut(path) {
            Some(rules) => rules.push((rule, new)),
            None => drop(known.insert(path.to_owned(), vec![(rule, new)])),
        }
        new
    }

    fn known(&self, path: &str, rule: &str) -> Option<T> {
        let known = self.known.borrow();
        known
            .get(path)?
            .iter()
            .find(|(other, _)| *other == rule)
            .map(|(_, answer)| *answer)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    #[test]
    fn an_answer_is_worked_out_once_for_each_path_and_rule() {
        let answered = Answered::default();
        let worked_out = Cell::new(0);
        let ask = |path: &str, rule| {
            answered.of(path, rule, || {
                worked_out.set(worked_out.get() + 1);
                (path.len(), rule)
            })
        };
        for _ in 0..1000 {
            assert_eq!(
                [ask("a", "x"), ask("a", "y"), ask("bb", "x")],
                [(1, "x"), (1, "y"), (2, "x")]
            );
        }
        assert_eq!(worked_out.get(), 3);
    }
}
