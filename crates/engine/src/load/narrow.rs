//! What the PATHs ask for in a tree.

use std::collections::BTreeSet;

use mhlint_source::is_below_any;

/// Printed paths that alone are asked for; none for everything.
#[derive(Debug, Clone, Default)]
pub(crate) struct Narrow {
    /// As they were given.
    paths: Vec<String>,
    /// The same, to find them by.
    known: BTreeSet<String>,
}

impl Narrow {
    pub(super) fn to(paths: Vec<String>) -> Self {
        let known = mhlint_source::without_slashes(paths.iter().cloned());
        Self { paths, known }
    }

    pub(super) fn is_whole(&self) -> bool {
        self.paths.is_empty()
    }

    pub(crate) fn paths(&self) -> &[String] {
        &self.paths
    }

    /// Whether a printed path is asked for.
    pub(super) fn asks_for(&self, path: &str) -> bool {
        self.is_whole() || is_below_any(path, &self.known)
    }

    /// Whether a printed path, or something below it, was named.
    pub(super) fn leads_into(&self, folder: &str) -> bool {
        let inside = format!("{folder}/");
        let mut from = self.known.range(inside.clone()..);
        self.known.contains(folder) || from.next().is_some_and(|path| path.starts_with(&inside))
    }

    /// Asks for other paths as well; it asks for everything if one of both does.
    pub(super) fn join(&mut self, other: &Self) {
        if self.is_whole() || other.is_whole() {
            *self = Self::default();
        } else {
            self.paths.extend_from_slice(&other.paths);
            self.known.extend(other.known.iter().cloned());
        }
    }
}
