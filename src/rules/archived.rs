//! Targets whose text MakeHuman 2 does not read, because an archive stands for it (formats/makehuman2.md §1.3, §6.2).
//!
//! What is wrong with such a text waits until the archive is deleted, which is the usual remedy for a stale one.

use super::target::{target_folder, usage};
use crate::diag::{Application, Finding, Level};
use crate::formats::npz::{Archive, Member};
use crate::repo::{FileFacts, Repository};

/// What a text that cannot be parsed does while an archive stands for it.
pub(super) const STOPS_LATER: &str = "stops at start as soon as the archive of the folder is deleted to be made anew";

/// Whether nobody parses the text: a sound archive lies in its folder and has the target, or nothing asks for it.
pub(super) fn is_unread(repository: &Repository<'_>, file: &FileFacts) -> bool {
    let is_unused = || usage::unused_paths(repository).contains(file.path.as_str());
    archive(repository, file).is_some_and(|archive| member(archive, file).is_some() || is_unused())
}

/// Whether the archive has other numbers than the text, so that those of the text are not applied.
pub(super) fn is_outdated(repository: &Repository<'_>, file: &FileFacts) -> bool {
    let rows = archive(repository, file).and_then(|archive| member(archive, file)?.rows.as_ref().ok());
    rows.zip(file.target()).is_some_and(|(rows, facts)| rows.content != facts.content)
}

/// A finding on a text that stops the program: while nobody parses it, only a warning of what comes.
pub(super) fn when_read(repository: &Repository<'_>, file: &FileFacts, finding: Finding) -> Finding {
    if is_unread(repository, file) {
        finding.level(Level::Warning).breaks(Application::Makehuman2, STOPS_LATER)
    } else {
        finding
    }
}

fn archive<'r>(repository: &'r Repository<'_>, file: &FileFacts) -> Option<&'r Archive> {
    let archive = repository.judged.file(&format!("{}/compressedtargets.npz", target_folder(file)))?.archive()?;
    archive.is_sound().then_some(archive)
}

fn member<'r>(archive: &'r Archive, file: &FileFacts) -> Option<&'r Member> {
    archive.member(file.rel.strip_prefix(target_folder(file))?.strip_prefix('/')?.strip_suffix(".target")?)
}
