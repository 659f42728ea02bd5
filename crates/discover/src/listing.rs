//! What is in a tree, asked by path: what lies around a sign of a data root decides what it is
//! worth.

use std::collections::BTreeSet;
use std::ops::Bound;

use super::layout::MAKEHUMAN2_BASES;

/// Bytes of a file that a look into it may ask for.
type Peek<'l> = &'l dyn Fn(&str) -> Option<Vec<u8>>;

/// The paths of a tree, and a look into the few files whose names do not say whose they are.
pub struct Listing<'l> {
    files: BTreeSet<&'l str>,
    folders: BTreeSet<&'l str>,
    /// Base meshes that the run knows from elsewhere.
    bases: BTreeSet<&'l str>,
    peek: Peek<'l>,
}

impl<'l> Listing<'l> {
    /// Of these files and folders.
    pub fn of(
        files: impl IntoIterator<Item = &'l str>,
        folders: impl IntoIterator<Item = &'l str>,
    ) -> Self {
        let (files, folders) = (files.into_iter().collect(), folders.into_iter().collect());
        Self {
            files,
            folders,
            bases: BTreeSet::new(),
            peek: &|_| None,
        }
    }

    /// The same where files can be looked into.
    #[must_use]
    pub fn with_contents(self, peek: Peek<'l>) -> Self {
        Self { peek, ..self }
    }

    /// The same where the run knows base meshes of these names.
    #[must_use]
    pub fn with_bases(self, bases: impl IntoIterator<Item = &'l str>) -> Self {
        Self {
            bases: bases.into_iter().collect(),
            ..self
        }
    }

    /// All files.
    pub(super) fn files(&self) -> impl Iterator<Item = &'l str> {
        self.files.iter().copied()
    }

    /// Whether there is a file at a path.
    pub(super) fn has(&self, path: &str) -> bool {
        self.files.contains(path)
    }

    /// Whether there is a folder at a path, be it empty.
    pub(super) fn has_folder(&self, path: &str) -> bool {
        self.folders.contains(path) || self.below(path).next().is_some()
    }

    /// The files below a folder; of the top all.
    pub fn below(&self, folder: &str) -> impl Iterator<Item = &'l str> + use<'_, 'l> {
        let prefix = if folder.is_empty() {
            String::new()
        } else {
            format!("{folder}/")
        };
        self.files
            .range::<str, _>((Bound::Included(prefix.as_str()), Bound::Unbounded))
            .copied()
            .take_while(move |path| path.starts_with(&prefix))
    }

    /// Whether the run knows a base mesh of this name.
    pub(super) fn knows_base(&self, name: &str) -> bool {
        MAKEHUMAN2_BASES.contains(&name) || self.bases.contains(name)
    }

    /// Whether one of these words stands in the file at a path.
    pub(super) fn says(&self, path: &str, words: &[&str]) -> bool {
        let Some(bytes) = (self.peek)(path) else {
            return false;
        };
        words.iter().any(|word| {
            bytes
                .windows(word.len())
                .any(|part| part == word.as_bytes())
        })
    }
}

/// A path below a folder; the top of a tree has no name.
pub(super) fn at(folder: &str, rel: &str) -> String {
    if folder.is_empty() {
        rel.to_owned()
    } else {
        format!("{folder}/{rel}")
    }
}
