//! One data root with the facts of its files.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use unicode_normalization::{UnicodeNormalization, is_nfc};

use super::FileFacts;
use crate::discover::kind_of;
use crate::source::WalkFault;

/// A path as a system compares it that regards neither capitals nor the form of accented letters.
pub fn fold(path: &str) -> String {
    composed(path).to_lowercase()
}

/// A path with whole letters where it has separate accent marks (Unicode normalization form C).
pub fn composed(path: &str) -> Cow<'_, str> {
    if path.is_ascii() || is_nfc(path) { Cow::Borrowed(path) } else { path.nfc().collect() }
}

/// One data root with the facts of its files.
#[derive(Debug)]
pub struct Layer {
    /// Path of the root as reports print it, empty for the working directory.
    pub path: String,
    /// Files by their path relative to the root.
    pub files: BTreeMap<String, FileFacts>,
    /// Folders, relative to the root.
    pub folders: Vec<String>,
    /// What the walk could not list, relative to the root.
    pub walk_faults: Vec<WalkFault>,
    /// Folded paths to paths, made when first asked for; with the number of files it was made for.
    folded: OnceLock<(usize, BTreeMap<String, String>)>,
}

impl Layer {
    /// A layer of these files.
    pub fn new(
        path: String,
        files: BTreeMap<String, FileFacts>,
        folders: Vec<String>,
        walk_faults: Vec<WalkFault>,
    ) -> Self {
        Self { path, files, folders, walk_faults, folded: OnceLock::new() }
    }

    /// The file at a path relative to the root.
    pub fn file(&self, rel: &str) -> Option<&FileFacts> {
        self.files.get(rel)
    }

    /// All files below a folder (no trailing slash), in order.
    pub fn below<'s>(&'s self, folder: &str) -> impl Iterator<Item = &'s FileFacts> + use<'s> {
        let prefix = format!("{folder}/");
        let from = self.files.range(prefix.clone()..);
        from.take_while(move |(rel, _)| rel.starts_with(&prefix)).map(|(_, file)| file)
    }

    /// The file whose path differs from `rel` in nothing but case, or the form of its accented letters.
    pub fn file_ignoring_case(&self, rel: &str) -> Option<&FileFacts> {
        let wanted = fold(rel);
        let (files, folded) = self.folded.get_or_init(|| (self.files.len(), self.folded()));
        if *files == self.files.len() {
            return self.files.get(folded.get(&wanted)?);
        }
        // Files were added since.
        self.files.values().find(|file| fold(&file.rel) == wanted)
    }

    /// Of paths that differ in case only, the first.
    fn folded(&self) -> BTreeMap<String, String> {
        let mut folded = BTreeMap::new();
        for rel in self.files.keys() {
            folded.entry(fold(rel)).or_insert_with(|| rel.clone());
        }
        folded
    }

    /// Path of something in this layer as reports print it.
    pub fn display(&self, rel: &str) -> String {
        if let Some(file) = self.file(rel) {
            return file.path.clone();
        }
        if let Some(folder) = self.below(rel).next().filter(|file| file.is_loose()).map(FileFacts::folder) {
            return if folder.is_empty() { ".".to_owned() } else { folder.to_owned() };
        }
        if self.path.is_empty() { rel.to_owned() } else { format!("{}/{rel}", self.path) }
    }

    /// Whether something other than a file stands at a path, or above it something that could not be walked.
    pub fn has_unusable(&self, rel: &str) -> bool {
        let is_here = |fault: &WalkFault| {
            let below = rel.strip_prefix(fault.path.as_str());
            below.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
        };
        // Folders with other names, such as those of images, are not reported.
        let is_folder = kind_of(rel).0.is_text() && self.folders.iter().any(|folder| folder == rel);
        is_folder || self.walk_faults.iter().any(is_here)
    }

    /// Whether a path as reports print it lies in this layer.
    pub fn holds(&self, path: &str) -> bool {
        self.relative(path).is_some()
    }

    /// The part of a printed path below this root.
    pub fn relative<'p>(&self, path: &'p str) -> Option<&'p str> {
        if self.path.is_empty() {
            return Some(path);
        }
        path.strip_prefix(self.path.as_str())?.strip_prefix('/')
    }
}
