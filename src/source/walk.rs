//! Lists a folder on disk: sorted, links followed inside the root only, loops and refusals reported.

use std::fs;
use std::path::{Path, PathBuf};

use walkdir::{DirEntry, WalkDir};

use super::tree::{Entry, EntryKind, WalkFault, WalkFaultKind};

/// Lists everything below `root` except hidden files and folders (`.git` and its kin),
/// not deeper than `depth` levels.
pub(super) fn walk(root: &Path, depth: usize) -> (Vec<Entry>, Vec<WalkFault>) {
    let canonical = fs::canonicalize(root).unwrap_or_else(|_| root.to_owned());
    let mut entries = Vec::new();
    let mut faults = Vec::new();
    let walk = WalkDir::new(root).follow_links(true).min_depth(1).max_depth(depth);
    let mut walker = walk.into_iter();
    while let Some(step) = walker.next() {
        match step {
            Ok(found) if is_hidden(&found) => skip_folder(&mut walker, &found),
            Ok(found) if found.path_is_symlink() && leaves(&canonical, found.path()) => {
                faults.push(fault(root, found.path(), WalkFaultKind::LinkLeavesRoot));
                skip_folder(&mut walker, &found);
            }
            Ok(found) => entries.push(entry(root, &found)),
            Err(error) => faults.push(walk_fault(root, &error)),
        }
    }
    entries.sort_by(|a, b| a.path.cmp(&b.path));
    faults.sort_by(|a, b| a.path.cmp(&b.path));
    (entries, faults)
}

fn skip_folder(walker: &mut walkdir::IntoIter, found: &DirEntry) {
    if found.file_type().is_dir() {
        walker.skip_current_dir();
    }
}

fn is_hidden(found: &DirEntry) -> bool {
    found.file_name().as_encoded_bytes().first() == Some(&b'.')
}

fn leaves(canonical_root: &Path, link: &Path) -> bool {
    fs::canonicalize(link).is_ok_and(|target| !target.starts_with(canonical_root))
}

fn entry(root: &Path, found: &DirEntry) -> Entry {
    let file_type = found.file_type();
    let kind = if file_type.is_file() {
        EntryKind::File
    } else if file_type.is_dir() {
        EntryKind::Folder
    } else {
        EntryKind::Special
    };
    let relative = relative(root, found.path());
    Entry {
        path: slashed(&relative),
        size: found.metadata().map_or(0, |metadata| metadata.len()),
        kind,
        native: relative,
    }
}

fn walk_fault(root: &Path, error: &walkdir::Error) -> WalkFault {
    let path = error.path().unwrap_or(root);
    let kind = if let Some(ancestor) = error.loop_ancestor() {
        WalkFaultKind::LinkLoop { back_to: slashed(&relative(root, ancestor)) }
    } else {
        WalkFaultKind::Unreadable { reason: reason(path, error) }
    };
    fault(root, path, kind)
}

fn reason(path: &Path, error: &walkdir::Error) -> String {
    if fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink()) {
        return match fs::read_link(path) {
            Ok(target) => format!("broken link to `{}`", target.display()),
            Err(_) => "broken link".to_owned(),
        };
    }
    error.io_error().map_or_else(|| "cannot be listed".to_owned(), ToString::to_string)
}

fn fault(root: &Path, path: &Path, kind: WalkFaultKind) -> WalkFault {
    WalkFault { path: slashed(&relative(root, path)), kind }
}

fn relative(root: &Path, path: &Path) -> PathBuf {
    path.strip_prefix(root).unwrap_or(path).to_owned()
}

fn slashed(path: &Path) -> String {
    let parts: Vec<_> = path.components().map(|part| part.as_os_str().to_string_lossy()).collect();
    parts.join("/")
}
