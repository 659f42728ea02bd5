//! The paths in a tree. How much a sign of a data root is worth depends on the paths around it.

use std::collections::BTreeSet;
use std::ops::Bound;

use super::layout::MAKEHUMAN2_BASES;

/// Reads the file at a path; `None` if it cannot be read, or is too large to be worth a look.
type Peek<'l> = &'l dyn Fn(&str) -> Option<Vec<u8>>;

/// The paths of a tree, and a function to look into the few files whose names do not tell which
/// application they belong to.
pub struct Listing<'l> {
    files: BTreeSet<&'l str>,
    folders: BTreeSet<&'l str>,
    /// Names of base meshes that are known from other inputs of the run.
    bases: BTreeSet<&'l str>,
    peek: Peek<'l>,
}

impl<'l> Listing<'l> {
    /// A listing of these files and folders.
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

    /// This listing, with a function to look into files.
    #[must_use]
    pub fn with_contents(self, peek: Peek<'l>) -> Self {
        Self { peek, ..self }
    }

    /// This listing, with names of base meshes that are known from other inputs.
    #[must_use]
    pub fn with_bases(self, bases: impl IntoIterator<Item = &'l str>) -> Self {
        Self {
            bases: bases.into_iter().collect(),
            ..self
        }
    }

    /// The paths of all files.
    pub(super) fn files(&self) -> impl Iterator<Item = &'l str> {
        self.files.iter().copied()
    }

    /// Whether there is a file at a path.
    pub(super) fn has(&self, path: &str) -> bool {
        self.files.contains(path)
    }

    /// Whether there is a folder at a path; it may be empty.
    pub(super) fn has_folder(&self, path: &str) -> bool {
        self.folders.contains(path) || self.below(path).next().is_some()
    }

    /// The files below a folder; all files if the folder is the top, whose path is empty.
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

    /// Whether a base mesh of this name is known.
    pub(super) fn knows_base(&self, name: &str) -> bool {
        MAKEHUMAN2_BASES.contains(&name) || self.bases.contains(name)
    }

    /// Whether the file at a path contains one of these words.
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

/// The path of `rel` in a folder. The top of a tree has an empty path.
pub(super) fn at(folder: &str, rel: &str) -> String {
    if folder.is_empty() {
        rel.to_owned()
    } else {
        format!("{folder}/{rel}")
    }
}
