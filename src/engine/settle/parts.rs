//! Names of what a finding speaks for, as a baseline writes them and knows them again.
//!
//! Thousands of vertices are mostly neighbours: numbers in a row are written as `first-last`.

use std::collections::{BTreeMap, BTreeSet};

/// The names as they are written: where all of them are numbers, those in a row as one.
pub(super) fn packed(parts: &[String]) -> Vec<String> {
    let Some(mut numbers) = parts.iter().map(|part| number(part)).collect::<Option<Vec<u64>>>() else {
        return parts.to_vec();
    };
    numbers.sort_unstable();
    numbers.dedup();
    let runs = numbers.chunk_by(|one, next| next - one == 1);
    let ends = runs.filter_map(|run| Some((run.first()?, run.last()?)));
    ends.map(|(first, last)| if first == last { first.to_string() } else { format!("{first}-{last}") }).collect()
}

/// Names that were there before.
#[derive(Debug, Default)]
pub(super) struct Names<'e> {
    plain: BTreeSet<&'e str>,
    /// Last number of each row by its first.
    rows: BTreeMap<u64, u64>,
}

impl<'e> Names<'e> {
    /// Those of some entries together.
    pub(super) fn of(parts: impl Iterator<Item = &'e String>) -> Self {
        let mut names = Self::default();
        for part in parts {
            names.plain.insert(part);
            if let Some((first, last)) = part.split_once('-').and_then(|(a, b)| Some((number(a)?, number(b)?))) {
                let known = names.rows.entry(first).or_default();
                *known = last.max(*known);
            }
        }
        names
    }

    /// Whether a name is among them.
    pub(super) fn hold(&self, part: &str) -> bool {
        let row = |number: u64| self.rows.range(..=number).any(|(_, last)| number <= *last);
        self.plain.contains(part) || number(part).is_some_and(row)
    }
}

/// A number as names have it: digits alone, none too many.
fn number(text: &str) -> Option<u64> {
    let number: u64 = text.parse().ok()?;
    (number.to_string() == text).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(parts: &[&str]) -> Vec<String> {
        parts.iter().map(|part| (*part).to_owned()).collect()
    }

    #[test]
    fn numbers_in_a_row_are_written_as_one() {
        assert_eq!(packed(&all(&["10", "11", "12", "3", "5"])), all(&["3", "5", "10-12"]));
        assert_eq!(packed(&all(&["1", "2", "toe.L"])), all(&["1", "2", "toe.L"]));
        assert_eq!(packed(&all(&["01", "2"])), all(&["01", "2"]));
        assert_eq!(packed(&[]), all(&[]));
    }

    #[test]
    fn what_was_packed_is_known_again_and_nothing_else() {
        let written = packed(&all(&["10", "11", "12", "3", "18446744073709551615"]));
        let names = Names::of(written.iter());
        let known = ["3", "10", "11", "12", "18446744073709551615"];
        assert!(known.iter().all(|part| names.hold(part)));
        assert!(["2", "4", "9", "13", "011", "10-11", "-3", ""].iter().all(|part| !names.hold(part)));
    }
}
