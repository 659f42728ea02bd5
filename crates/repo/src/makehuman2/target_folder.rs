//! Folders that targets are loaded from.

use super::OWN;
use crate::{FileFacts, Layer};
use mhlint_discover::Kind;

/// A folder that targets are loaded from.
#[derive(Debug, Clone, Copy)]
pub struct TargetFolder<'a> {
    /// Its layer.
    pub layer: &'a Layer,
    /// `target` or `contarget`.
    pub folder: &'static str,
    /// Base mesh.
    pub base: &'a str,
}

impl<'a> TargetFolder<'a> {
    /// Path relative to its root, without trailing slash.
    pub fn rel(&self) -> String {
        format!("{}/{}", self.folder, self.base)
    }

    /// The target `name` (path without suffix).
    pub fn target(&self, name: &str) -> Option<&'a FileFacts> {
        self.layer
            .file(&format!("{}/{}/{name}.target", self.folder, self.base))
    }

    /// `compressedtargets.npz` of the folder.
    pub fn archive(&self) -> Option<&'a FileFacts> {
        self.layer.file(&format!(
            "{}/{}/compressedtargets.npz",
            self.folder, self.base
        ))
    }

    /// All targets in the folder.
    pub fn targets(&self) -> impl Iterator<Item = &'a FileFacts> + use<'a> {
        self.layer
            .below(&self.rel())
            .filter(|file| file.kind_in(OWN) == Kind::Target)
    }

    /// Name of a target of this folder as files refer to it: path without suffix.
    pub fn name_of<'f>(&self, file: &'f FileFacts) -> Option<&'f str> {
        file.rel
            .strip_prefix(&self.rel())?
            .strip_prefix('/')?
            .strip_suffix(".target")
    }

    /// Whether anything is in it.
    pub fn exists(&self) -> bool {
        self.layer.below(&self.rel()).next().is_some()
    }
}

/// The folder that the targets of a base are loaded from: the first two parts of their paths.
pub(super) fn of(file: &FileFacts) -> &str {
    let end = file
        .rel
        .match_indices('/')
        .nth(1)
        .map_or(file.rel.len(), |(at, _)| at);
    file.rel.get(..end).unwrap_or(&file.rel)
}
