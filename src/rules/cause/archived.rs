//! Targets whose text MakeHuman 2 does not read, because an archive stands for it (formats/makehuman2.md §1.3, §6.2).
//!
//! What is wrong with such a text waits until the archive is deleted, which is the usual remedy for a stale one.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use super::consequence::{Damage, consequence};
use super::usage;
use crate::diag::Finding;
use crate::formats::npz::{Archive, Member};
use crate::repo::{FileFacts, Layer, Repository};

/// Targets whose text nobody parses.
pub(in crate::rules) struct Unread<'r, 'a> {
    repository: &'r Repository<'a>,
    /// Looked for when the first target asks that its archive lacks.
    unused: OnceCell<BTreeSet<&'a str>>,
}

impl<'r, 'a> Unread<'r, 'a> {
    pub(in crate::rules) const fn of(repository: &'r Repository<'a>) -> Self {
        Self { repository, unused: OnceCell::new() }
    }

    /// Whether a sound archive lies in the folder and has the target, or nothing asks for it.
    fn hold(&self, file: &FileFacts) -> bool {
        let unused = || self.unused.get_or_init(|| usage::unused_paths(self.repository));
        let is_unused = || unused().contains(file.path.as_str());
        archive(self.repository, file).is_some_and(|archive| member(archive, file).is_some() || is_unused())
    }

    /// A finding on a text that stops the program: while nobody parses it, only a warning of what comes.
    pub(in crate::rules) fn weigh(&self, file: &FileFacts, finding: Finding) -> Finding {
        if self.hold(file) { stops_later(self.repository, file, finding) } else { finding }
    }
}

/// A finding on a text that stops the program only when its archive is gone.
pub(in crate::rules) fn stops_later(repository: &Repository<'_>, file: &FileFacts, finding: Finding) -> Finding {
    match consequence(repository, &file.rel, Damage::Archived) {
        Some(later) => later.of(finding),
        None => finding,
    }
}

/// Whether the archive has other numbers than the text, so that those of the text are not applied.
pub(in crate::rules) fn is_outdated(repository: &Repository<'_>, file: &FileFacts) -> bool {
    let rows = archive(repository, file).and_then(|archive| member(archive, file)?.rows.as_ref().ok());
    rows.zip(file.target()).is_some_and(|(rows, facts)| rows.content != facts.content)
}

/// The archive of the folder that a target is loaded from, sound or not.
pub(in crate::rules) fn beside<'l>(layer: &'l Layer, file: &FileFacts) -> Option<&'l FileFacts> {
    layer.file(&format!("{}/compressedtargets.npz", target_folder(file)))
}

/// The archive that stands for the texts of the folder.
pub(in crate::rules) fn archive<'r>(repository: &'r Repository<'_>, file: &FileFacts) -> Option<&'r Archive> {
    let archive = beside(repository.judged, file)?.archive()?;
    archive.is_sound().then_some(archive)
}

fn member<'r>(archive: &'r Archive, file: &FileFacts) -> Option<&'r Member> {
    archive.member(file.rel.strip_prefix(target_folder(file))?.strip_prefix('/')?.strip_suffix(".target")?)
}

/// The folder that targets of a base are loaded from: the first two parts of the path.
pub(in crate::rules) fn target_folder(file: &FileFacts) -> &str {
    let end = file.rel.match_indices('/').nth(1).map_or(file.rel.len(), |(at, _)| at);
    file.rel.get(..end).unwrap_or(&file.rel)
}

/// Whether a binary archive stands for the target; a changed text would no longer be what the application loads.
pub(in crate::rules) fn is_archived(layer: &Layer, file: &FileFacts) -> bool {
    beside(layer, file).is_some()
}
