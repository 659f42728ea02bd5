//! Numbers behind a finding: one cause is one finding, with counts instead of repetitions.

use serde::Serialize;

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
    /// Where the examples stand for groups of the counted elements (patterns, files): how many groups.
    #[serde(skip)]
    pub groups: Option<u64>,
    /// The worst value and where it is.
    pub worst: Option<Worst>,
    /// All of them, to tell a later run what was there before; empty where they are too many or have no names.
    #[serde(skip)]
    pub cases: Vec<String>,
}

/// The worst value of a finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Worst {
    /// The number.
    pub value: f64,
    /// Where it was seen.
    pub place: String,
}

impl Evidence {
    /// Evidence from all cases; keeps the first few as examples.
    pub fn of_cases<T: ToString>(cases: impl IntoIterator<Item = T>) -> Self {
        let mut evidence = Self::default();
        for case in cases {
            evidence.count += 1;
            let case = case.to_string();
            if evidence.examples.len() < EXAMPLES {
                evidence.examples.push(case.clone());
            }
            evidence.cases.push(case);
        }
        evidence
    }

    /// Evidence on `count` elements that are named in groups: by pattern, by file.
    pub fn of_groups<T: ToString>(groups: impl IntoIterator<Item = T>, count: u64) -> Self {
        let named = Self::of_cases(groups);
        Self { count, groups: Some(named.count), ..named }
    }

    /// For cases that are told by line, by number or in words: a later run cannot know them by these again.
    #[must_use]
    pub fn unnamed(mut self) -> Self {
        self.cases.clear();
        self
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
        self.worst = Some(Worst { value, place: place.into() });
        self
    }
}

/// Counts rows of a bulk file while a parser walks it: how many, the first few with line and index.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Tally {
    /// How many rows.
    pub count: u64,
    /// The first few: line (from 1) and vertex index as written.
    pub first: Vec<(u32, i64)>,
    /// Indices of all rows, as long as they are few.
    #[serde(skip)]
    indices: Vec<i64>,
}

impl Tally {
    /// Counts one row.
    pub fn add(&mut self, line: u32, index: i64) {
        self.count += 1;
        if self.first.len() < EXAMPLES {
            self.first.push((line, index));
        }
        if self.indices.len() <= NAMED_ROWS {
            self.indices.push(index);
        }
    }

    /// Line of the first row counted.
    pub fn first_line(&self) -> Option<u32> {
        self.first.first().map(|(line, _)| *line)
    }

    /// As evidence out of `total` rows, the indices as examples.
    pub fn evidence(&self, total: usize) -> Evidence {
        Evidence {
            count: self.count,
            of: Some(total as u64),
            examples: self.first.iter().map(|(_, index)| index.to_string()).collect(),
            cases: self.names(),
            ..Evidence::default()
        }
    }
    fn names(&self) -> Vec<String> {
        if self.indices.len() > NAMED_ROWS { Vec::new() } else { self.indices.iter().map(i64::to_string).collect() }
    }
}
