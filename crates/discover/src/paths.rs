//! The paths in a data root, with what else tells its version.

use std::collections::BTreeSet;
use std::ops::Bound;

/// What tells the version of the data of a program.
pub struct Paths<'p> {
    all: BTreeSet<&'p str>,
    /// Vertices and texture coordinates of the base mesh, 0 where there is none.
    pub mesh: (usize, usize),
    /// What is in the file at a path.
    peek: &'p dyn Fn(&str) -> Option<Vec<u8>>,
}

impl<'p> Paths<'p> {
    /// Of the files at these paths below the data root.
    pub fn of(
        all: impl Iterator<Item = &'p str>,
        mesh: (usize, usize),
        peek: &'p dyn Fn(&str) -> Option<Vec<u8>>,
    ) -> Self {
        Self {
            all: all.collect(),
            mesh,
            peek,
        }
    }

    /// All of them.
    pub fn all(&self) -> impl Iterator<Item = &'p str> {
        self.all.iter().copied()
    }

    /// The first that begins so.
    pub fn first(&self, start: &str) -> Option<&'p str> {
        let mut from = self
            .all
            .range::<str, _>((Bound::Included(start), Bound::Unbounded));
        from.next().copied().filter(|path| path.starts_with(start))
    }

    /// Whether one begins so.
    pub fn has(&self, start: &str) -> bool {
        self.first(start).is_some()
    }

    /// Whether one begins and ends so.
    pub fn has_kind(&self, start: &str, end: &str) -> bool {
        self.all
            .iter()
            .any(|path| path.starts_with(start) && path.ends_with(end))
    }

    /// Whether a word stands in the file at a path.
    pub fn says(&self, rel: &str, word: &str) -> bool {
        (self.peek)(rel)
            .is_some_and(|text| text.windows(word.len()).any(|part| part == word.as_bytes()))
    }
}
