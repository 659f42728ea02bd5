//! Lines that are not what their section or keyword wants: counted by kind, the first few of each
//! kept.

use std::ops::Range;

use mhlint_diag::EXAMPLES;

/// A line that is not what its section or keyword wants.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Line from 1.
    pub line: u32,
    /// What is wrong.
    pub kind: FaultKind,
    /// The word that is wrong, or the first of the line.
    pub word: Box<str>,
    /// Where it stands, in bytes.
    pub span: Range<usize>,
}

/// The kinds of [`Fault`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultKind {
    /// A vertex line with 2 to 5, 7 or 8 words.
    FieldCount(usize),
    /// A word of a vertex line that is not a number.
    RowWord,
    /// A line among the vertices that is meant as one and is taken for a keyword.
    DroppedRow,
    /// Numbers before any section.
    NumbersInHeader,
    /// A scale without all of its values.
    ShortScale,
    /// A word of a scale that is not a number.
    ScaleWord,
    /// `z_depth` or `version` that is not a whole number.
    NotWhole,
    /// A keyword without its value.
    MissingValue,
    /// `weights`, of an old format.
    OldFormat,
    /// A word among the vertices to delete that is not a whole number.
    DeleteWord,
    /// `-` with nothing before it in the delete section.
    OpenRange,
}

/// All faults of a file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Faults {
    kinds: Vec<(Vec<Fault>, u64)>,
}

impl Faults {
    /// Counts a fault.
    pub(super) fn add(&mut self, fault: Fault) {
        let same = |(first, _): &&mut (Vec<Fault>, u64)| {
            first.first().is_some_and(|known| {
                std::mem::discriminant(&known.kind) == std::mem::discriminant(&fault.kind)
            })
        };
        match self.kinds.iter_mut().find(same) {
            Some((first, count)) => {
                *count += 1;
                if first.len() < EXAMPLES {
                    first.push(fault);
                }
            }
            None => self.kinds.push((vec![fault], 1)),
        }
    }

    /// The first few faults of one kind, and how many there are.
    pub fn of(&self, is_wanted: impl Fn(FaultKind) -> bool) -> Option<(&[Fault], u64)> {
        let of_kind = |(first, _): &&(Vec<Fault>, u64)| {
            first.first().is_some_and(|fault| is_wanted(fault.kind))
        };
        self.kinds
            .iter()
            .find(of_kind)
            .map(|(first, count)| (first.as_slice(), *count))
    }

    /// The first few of each kind.
    pub fn iter(&self) -> impl Iterator<Item = &Fault> {
        self.kinds.iter().flat_map(|(first, _)| first)
    }

    /// The first fault in the file that is asked for.
    pub fn first<T>(&self, ask: impl Fn(&Fault) -> Option<T>) -> Option<(u32, T)> {
        let found = self
            .iter()
            .filter_map(|fault| Some((fault.line, ask(fault)?)));
        found.min_by_key(|(line, _)| *line)
    }
}
