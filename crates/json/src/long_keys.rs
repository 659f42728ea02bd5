//! Keys that are too long to be repeated in the place of each fault below them.
//!
//! The validator collects all faults, each with its whole place: it gets a tree in which long keys
//! are short.

use std::collections::HashMap;

use serde_json::{Map, Value};

use mhlint_diag::add_step;

/// Longest key that the validator gets as it is, in bytes. No schema knows one that is nearly as
/// long.
const LONGEST: usize = 256;
/// Letters of a longer one that remain.
const KEPT: usize = 32;

/// The long keys of a tree: what stands for each of them, and the key as a step of a pointer.
#[derive(Default)]
pub(super) struct LongKeys {
    steps: HashMap<String, String>,
}

impl LongKeys {
    /// Puts short keys in the place of long ones.
    pub(super) fn shorten(&mut self, value: &mut Value) {
        match value {
            Value::Array(elements) => elements
                .iter_mut()
                .for_each(|element| self.shorten(element)),
            Value::Object(members) => {
                if members.keys().any(|key| key.len() > LONGEST) {
                    let all: Map<String, Value> = std::mem::take(members);
                    *members = all
                        .into_iter()
                        .map(|(key, value)| (self.short(key), value))
                        .collect();
                }
                members.values_mut().for_each(|value| self.shorten(value));
            }
            _ => {}
        }
    }

    fn short(&mut self, key: String) -> String {
        if key.len() <= LONGEST {
            return key;
        }
        let begin = key
            .chars()
            .filter(|letter| !matches!(letter, '/' | '~'))
            .take(KEPT);
        let short = format!("{}\u{0}{}", begin.collect::<String>(), self.steps.len());
        let mut step = String::new();
        add_step(&mut step, &key);
        self.steps.insert(short.clone(), step);
        short
    }

    /// The pointer in the text that was shortened.
    pub(super) fn restored(&self, pointer: String) -> String {
        if self.steps.is_empty() {
            return pointer;
        }
        let step = |step: &str| {
            self.steps
                .get(step)
                .cloned()
                .unwrap_or_else(|| format!("/{step}"))
        };
        pointer.split('/').skip(1).map(step).collect()
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn long_keys_become_short_and_pointers_long_again() {
        let long = ["a/b~".repeat(100), "a/b~".repeat(101)];
        let mut tree = json!({"a/b": [{&long[0]: {"x": 1}, &long[1]: 2, "c": 3}]});
        let mut keys = LongKeys::default();
        keys.shorten(&mut tree);
        let members = tree["a/b"][0].as_object().unwrap();
        assert!(members.len() == 3 && members.keys().all(|key| key.len() < 100));
        let short = members
            .iter()
            .find(|(_, value)| value.is_object())
            .unwrap()
            .0;
        let expected = format!("/a~1b/0/{}/x", "a~1b~0".repeat(100));
        assert_eq!(keys.restored(format!("/a~1b/0/{short}/x")), expected);
        assert_eq!(keys.restored("/a~1b/0/c".to_owned()), "/a~1b/0/c");
        assert_eq!(keys.restored(String::new()), "");
    }
}
