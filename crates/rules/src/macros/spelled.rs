//! Which values of the components a file name spells, and which combinations that leaves.
//!
//! File names are free: words that are no values (`universal`, `allmuscle`) say nothing.

use super::fit::values_of;
use super::space::{Combination, Space};

/// For each component the values that a name spells; none where it spells no value of it.
pub(super) struct Spelled(Vec<Vec<usize>>);

impl Spelled {
    pub(super) fn of(space: &Space<'_>, name: &str) -> Self {
        let words = values_of(name);
        let of_axis = |values: &Vec<String>| -> Vec<usize> {
            values
                .iter()
                .enumerate()
                .filter(|(_, value)| words.contains(value.as_str()))
                .map(|(at, _)| at)
                .collect()
        };
        Self(
            space
                .axes
                .iter()
                .map(|axis| of_axis(&axis.values))
                .collect(),
        )
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.iter().all(Vec::is_empty)
    }

    pub(super) fn fits(&self, combination: &[usize]) -> bool {
        self.0
            .iter()
            .zip(combination)
            .all(|(values, value)| values.is_empty() || values.contains(value))
    }

    /// All combinations that fit.
    pub(super) fn combinations(&self, sizes: &[usize]) -> Vec<Combination> {
        let mut all: Vec<Combination> = vec![Vec::new()];
        for (values, size) in self.0.iter().zip(sizes) {
            let choice: Vec<usize> = if values.is_empty() {
                (0..*size).collect()
            } else {
                values.clone()
            };
            let longer = |head: &Combination| -> Vec<Combination> {
                choice
                    .iter()
                    .map(|value| head.iter().copied().chain([*value]).collect())
                    .collect()
            };
            all = all.iter().flat_map(longer).collect();
        }
        all
    }

    /// The only combination that fits both, where the first leaves something open the second.
    pub(super) fn completed(&self, other: &Self) -> Option<Combination> {
        let of_axis =
            |(own, other): (&Vec<usize>, &Vec<usize>)| match (own.as_slice(), other.as_slice()) {
                ([one], _) | ([], [one]) => Some(*one),
                _ => None,
            };
        self.0.iter().zip(&other.0).map(of_axis).collect()
    }
}
