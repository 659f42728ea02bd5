//! Numbers behind a finding: one cause is one finding, with counts instead of repetitions.

use serde::Serialize;

use super::{Name, Parts};

/// How many examples a finding carries.
pub const EXAMPLES: usize = 5;
/// Rows of a bulk file that are told apart by name; more of them are one mass.
const NAMED_ROWS: usize = 65_536;

/// What was counted.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Evidence {
    /// How many elements show the fault.
    pub count: u64,
    /// Out of how many, where that is known.
    pub of: Option<u64>,
    /// The first few.
    pub examples: Vec<String>,
    /// Where the examples stand for groups of the counted elements (patterns, files): how many
    /// groups.
    #[serde(skip)]
    pub groups: Option<u64>,
    /// The worst value and where it is.
    pub worst: Option<Worst>,
}

/// The worst value of a finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Worst {
    /// The number.
    pub value: f64,
    /// Where it was seen.
    pub place: String,
}

/// Evidence with the names of everything that was counted, for the [`super::Subject`] of its
/// finding.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cases {
    pub(super) evidence: Evidence,
    /// None where they are told by line, by number or in words: a later run cannot know them by
    /// these again.
    pub(super) parts: Parts,
}

impl Evidence {
    /// Evidence from all cases by name; keeps the first few as examples.
    pub fn of_cases<T: ToString + Into<Name>>(cases: impl IntoIterator<Item = T>) -> Cases {
        let mut evidence = Self::default();
        let parts = cases
            .into_iter()
            .inspect(|case| evidence.add(case))
            .collect();
        Cases { evidence, parts }
    }

    /// Evidence from all cases, told by line, by number or in words.
    pub fn of_unnamed<T: ToString>(cases: impl IntoIterator<Item = T>) -> Self {
        let mut evidence = Self::default();
        cases.into_iter().for_each(|case| evidence.add(&case));
        evidence
    }

    /// Evidence on `count` elements that are told in groups: by pattern, by file.
    pub fn of_groups<T: ToString>(groups: impl IntoIterator<Item = T>, count: u64) -> Self {
        let told = Self::of_unnamed(groups);
        Self {
            count,
            groups: Some(told.count),
            ..told
        }
    }

    /// Evidence on `count` elements, without examples.
    pub fn counted(count: usize) -> Self {
        Self {
            count: count as u64,
            ..Self::default()
        }
    }

    fn add(&mut self, case: &impl ToString) {
        self.count += 1;
        if self.examples.len() < EXAMPLES {
            self.examples.push(case.to_string());
        }
    }

    /// Says out of how many.
    #[must_use]
    pub fn out_of(mut self, total: usize) -> Self {
        self.of = Some(total as u64);
        self
    }

    /// Adds the worst value.
    #[must_use]
    pub fn with_worst(mut self, value: f64, place: impl Into<String>) -> Self {
        self.worst = Some(Worst {
            value,
            place: place.into(),
        });
        self
    }

    /// With the names of everything that was counted.
    pub fn naming<T: Into<Name>>(self, names: impl IntoIterator<Item = T>) -> Cases {
        Cases {
            evidence: self,
            parts: names.into_iter().collect(),
        }
    }
}

impl Cases {
    /// With other examples: where the cases are, say.
    #[must_use]
    pub fn showing(mut self, examples: impl Iterator<Item = String>) -> Self {
        self.evidence.examples = examples.collect();
        self
    }

    /// As [`Evidence::out_of`].
    #[must_use]
    pub fn out_of(self, total: usize) -> Self {
        Self {
            evidence: self.evidence.out_of(total),
            ..self
        }
    }

    /// As [`Evidence::with_worst`].
    #[must_use]
    pub fn with_worst(self, value: f64, place: impl Into<String>) -> Self {
        Self {
            evidence: self.evidence.with_worst(value, place),
            ..self
        }
    }
}

impl From<Evidence> for Cases {
    fn from(evidence: Evidence) -> Self {
        Self {
            evidence,
            parts: Parts::default(),
        }
    }
}

/// Bytes of names that are kept; more of them are one mass.
const NAMED_BYTES: usize = 8 << 20;

/// Names, as long as they are few. Costs nothing where there are none.
#[derive(Debug, Clone, PartialEq)]
pub struct Few<T> {
    names: Vec<T>,
    /// How long they are together, as far as anyone said so.
    bytes: usize,
}

impl<T> Few<T> {
    /// Adds a name.
    pub fn add(&mut self, name: impl FnOnce() -> T) {
        self.add_long(0, name);
    }

    /// The same for a name of about this many bytes: it may come from a stranger.
    pub fn add_long(&mut self, bytes: usize, name: impl FnOnce() -> T) {
        if self.are_few() {
            self.bytes = self.bytes.saturating_add(bytes);
            self.names.push(name());
        }
    }

    const fn are_few(&self) -> bool {
        self.names.len() <= NAMED_ROWS && self.bytes <= NAMED_BYTES
    }

    /// The names, or none where they are too many.
    pub fn names(&self) -> &[T] {
        if self.are_few() { &self.names } else { &[] }
    }
}

impl<T> Default for Few<T> {
    fn default() -> Self {
        Self {
            names: Vec::new(),
            bytes: 0,
        }
    }
}

/// Counts rows of a bulk file while a parser walks it: how many, the first few with line and index.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// How many rows.
    pub count: u64,
    /// The first few: line (from 1) and vertex index as written.
    pub first: Vec<(u32, i64)>,
    /// Indices of all rows.
    indices: Few<i64>,
}

impl Tally {
    /// Counts one row.
    pub fn add(&mut self, line: u32, index: i64) {
        self.count += 1;
        if self.first.len() < EXAMPLES {
            self.first.push((line, index));
        }
        self.indices.add(|| index);
    }

    /// Line of the first row counted.
    pub fn first_line(&self) -> Option<u32> {
        self.first.first().map(|(line, _)| *line)
    }

    /// As evidence out of `total` rows, the indices as examples.
    pub fn evidence(&self, total: usize) -> Cases {
        let examples = self
            .first
            .iter()
            .map(|(_, index)| index.to_string())
            .collect();
        let evidence = Evidence {
            count: self.count,
            of: Some(total as u64),
            examples,
            ..Evidence::default()
        };
        evidence.naming(self.indices.names())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_many_rows_have_no_names() {
        let mut rows = Few::default();
        (0..NAMED_ROWS).for_each(|row| rows.add(|| row));
        assert_eq!(rows.names().len(), NAMED_ROWS);
        (0..NAMED_ROWS).for_each(|row| rows.add(|| row));
        assert_eq!((rows.names().len(), rows.names.len()), (0, NAMED_ROWS + 1));
    }

    #[test]
    fn names_that_are_too_long_are_not_kept() {
        let mut names = Few::default();
        (0..100).for_each(|_| names.add_long(1 << 20, || ()));
        assert_eq!((names.names().len(), names.names.len()), (0, 9));
    }
}
