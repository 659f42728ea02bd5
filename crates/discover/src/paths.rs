//! The paths in a data root, with the other facts that tell which version the data are of.

use std::collections::BTreeSet;
use std::ops::Bound;

/// The facts that tell which version the data of a program are of.
pub struct Paths<'p> {
    all: BTreeSet<&'p str>,
    /// The numbers of vertices and texture coordinates of the base mesh; 0 if there is none.
    pub mesh: (usize, usize),
    /// Reads the file at a path; `None` if it cannot be read.
    peek: &'p dyn Fn(&str) -> Option<Vec<u8>>,
}

impl<'p> Paths<'p> {
    /// The facts on a data root that has files at these paths.
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

    /// All paths.
    pub fn all(&self) -> impl Iterator<Item = &'p str> {
        self.all.iter().copied()
    }

    /// The first path that begins with `start`.
    pub fn first(&self, start: &str) -> Option<&'p str> {
        let mut from = self
            .all
            .range::<str, _>((Bound::Included(start), Bound::Unbounded));
        from.next().copied().filter(|path| path.starts_with(start))
    }

    /// Whether a path begins with `start`.
    pub fn has(&self, start: &str) -> bool {
        self.first(start).is_some()
    }

    /// Whether a path begins with `start` and ends with `end`.
    pub fn has_kind(&self, start: &str, end: &str) -> bool {
        self.all
            .iter()
            .any(|path| path.starts_with(start) && path.ends_with(end))
    }

    /// Whether the file at a path contains a word.
    pub fn says(&self, rel: &str, word: &str) -> bool {
        (self.peek)(rel)
            .is_some_and(|text| text.windows(word.len()).any(|part| part == word.as_bytes()))
    }
}
