//! Targets whose text MakeHuman 2 does not read, because an archive stands for it (formats/makehuman2.md §1.3, §6.2).
//!
//! What is wrong with such a text waits until the archive is deleted, which is the usual remedy for a stale one.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use super::target::{target_folder, usage};
use crate::diag::{Application, Finding, Level};
use crate::formats::npz::{Archive, Member};
use crate::repo::{FileFacts, Layer, Repository};

/// What a text that cannot be parsed does while an archive stands for it.
pub(super) const STOPS_LATER: &str = "stops at start as soon as the archive of the folder is deleted to be made anew";

/// Targets whose text nobody parses.
pub(super) struct Unread<'r, 'a> {
    repository: &'r Repository<'a>,
    /// Looked for when the first target asks that its archive lacks.
    unused: OnceCell<BTreeSet<&'a str>>,
}

impl<'r, 'a> Unread<'r, 'a> {
    pub(super) const fn of(repository: &'r Repository<'a>) -> Self {
        Self { repository, unused: OnceCell::new() }
    }

    /// Whether a sound archive lies in the folder and has the target, or nothing asks for it.
    fn hold(&self, file: &FileFacts) -> bool {
        let unused = || self.unused.get_or_init(|| usage::unused_paths(self.repository));
        let is_unused = || unused().contains(file.path.as_str());
        archive(self.repository, file).is_some_and(|archive| member(archive, file).is_some() || is_unused())
    }

    /// A finding on a text that stops the program: while nobody parses it, only a warning of what comes.
    pub(super) fn weigh(&self, file: &FileFacts, finding: Finding) -> Finding {
        if self.hold(file) {
            finding.level(Level::Warning).breaks(Application::Makehuman2, STOPS_LATER)
        } else {
            finding
        }
    }
}

/// Whether the archive has other numbers than the text, so that those of the text are not applied.
pub(super) fn is_outdated(repository: &Repository<'_>, file: &FileFacts) -> bool {
    let rows = archive(repository, file).and_then(|archive| member(archive, file)?.rows.as_ref().ok());
    rows.zip(file.target()).is_some_and(|(rows, facts)| rows.content != facts.content)
}

/// The archive of the folder that a target is loaded from, sound or not.
pub(super) fn beside<'l>(layer: &'l Layer, file: &FileFacts) -> Option<&'l FileFacts> {
    layer.file(&format!("{}/compressedtargets.npz", target_folder(file)))
}

/// The archive that stands for the texts of the folder.
pub(super) fn archive<'r>(repository: &'r Repository<'_>, file: &FileFacts) -> Option<&'r Archive> {
    let archive = beside(repository.judged, file)?.archive()?;
    archive.is_sound().then_some(archive)
}

fn member<'r>(archive: &'r Archive, file: &FileFacts) -> Option<&'r Member> {
    archive.member(file.rel.strip_prefix(target_folder(file))?.strip_prefix('/')?.strip_suffix(".target")?)
}
