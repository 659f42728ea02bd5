//! Entries of a tree by path, with the folders on the way to them.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::tree::{Entry, EntryKind, WalkFault, WalkFaultKind};
use super::walk;
use crate::path::first_name;

/// Enters the folders on the way to a path.
pub(super) fn add_folders(entries: &mut BTreeMap<String, Entry>, path: &str) {
    let new: Vec<&str> = new_folders(entries, path).collect();
    entries.extend(new.into_iter().map(|folder| {
        (
            folder.to_owned(),
            memory_entry(folder, EntryKind::Folder, 0),
        )
    }));
}

/// The folders on the way to a path that are not there yet, innermost first. Those above one that
/// is there are, too.
fn new_folders<'p>(
    entries: &BTreeMap<String, Entry>,
    path: &'p str,
) -> impl Iterator<Item = &'p str> {
    folders_above(path)
        .rev()
        .take_while(|folder| !entries.contains_key(*folder))
}

/// Letters of paths that are still to be listed; nothing more once they are too many.
pub(super) struct Room(pub(super) usize);

impl Room {
    /// Whether a path and the new folders on the way to it are to be listed. If not, where listing
    /// was given up.
    pub(super) fn take(
        &mut self,
        entries: &BTreeMap<String, Entry>,
        path: &str,
    ) -> Result<(), WalkFault> {
        let letters = path.len() + new_folders(entries, path).map(str::len).sum::<usize>();
        self.0 = self.0.checked_sub(letters).ok_or_else(|| {
            let top = first_name(path).to_owned();
            WalkFault {
                path: top,
                kind: WalkFaultKind::Unreadable {
                    reason: walk::TOO_LONG.to_owned(),
                },
            }
        })?;
        Ok(())
    }
}

/// The folders on the way to a path, outermost first.
pub(super) fn folders_above(path: &str) -> impl DoubleEndedIterator<Item = &str> {
    path.match_indices('/').filter_map(|(at, _)| path.get(..at))
}

/// Entries of these files, by path with their sizes, and where that was given up: a file deep in
/// folders makes an entry of each of them.
pub(super) fn memory_entries<'p>(
    files: impl IntoIterator<Item = (&'p str, u64)>,
) -> (Vec<Entry>, Vec<WalkFault>) {
    let mut entries: BTreeMap<String, Entry> = BTreeMap::new();
    let mut room = Room(walk::MOST_LETTERS);
    for (path, size) in files {
        if let Err(fault) = room.take(&entries, path) {
            return (entries.into_values().collect(), vec![fault]);
        }
        add_folders(&mut entries, path);
        if !path.ends_with('/') {
            add_file(&mut entries, path, size);
        }
    }
    (entries.into_values().collect(), Vec::new())
}

fn memory_entry(path: &str, kind: EntryKind, size: u64) -> Entry {
    Entry {
        path: path.to_owned(),
        kind,
        size,
        native: PathBuf::from(path),
        link_to: None,
    }
}

pub(super) fn add_file(entries: &mut BTreeMap<String, Entry>, path: &str, size: u64) {
    let entry = entries
        .entry(path.to_owned())
        .or_insert_with(|| memory_entry(path, EntryKind::File, 0));
    (entry.kind, entry.size) = (EntryKind::File, size);
}
