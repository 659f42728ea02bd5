//! Lists a folder on disk: sorted, links followed inside the root only, loops and refusals
//! reported.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

use walkdir::{DirEntry, WalkDir};

use super::place::{LONGEST_CHAIN, folder_name, resolved, slashed};
use super::tree::{Entry, EntryKind, WalkFault, WalkFaultKind};

/// Entries that are listed at most: folders that link to each other multiply without end, and no
/// asset repository comes near.
const MOST_ENTRIES: usize = 1_000_000;
/// The same of entries behind links to folders: each of the files is read once for each way that
/// leads to it.
const MOST_LINKED: usize = 10_000;
/// Letters of all paths that are listed at most: each folder deep in others has all of their names
/// in its own.
pub(super) const MOST_LETTERS: usize = 32 << 20;
/// What is said where they are passed.
pub(super) const TOO_LONG: &str =
    "the paths take more than 32 MiB in total; the rest was not checked";

/// Says of a hidden path, or of a path in a hidden folder, whether somebody has an eye on it: a
/// file that is to be listed, or (`true` behind it) a folder that is to be listed and searched.
/// Before the path stands the name of the folder that is listed.
pub(super) type Wanted = fn(&str, &str, bool) -> bool;

/// What the names of journals begin with that runs leave which are killed while they fix.
pub const JOURNAL: &str = ".mhlint-journal-";

/// What a walk finds.
pub(super) struct Walk {
    pub(super) entries: Vec<Entry>,
    pub(super) faults: Vec<WalkFault>,
    /// Journals of runs that fix, from the top of the tree.
    pub(super) journals: Vec<PathBuf>,
}

/// Lists everything below `root`, of hidden files and what is in hidden folders (`.git` and its
/// kin) only what is `wanted`, not deeper than `depth` levels.
pub(super) fn walk(root: &Path, depth: usize, wanted: Wanted) -> Walk {
    walk_at_most(root, depth, wanted, MOST_ENTRIES)
}

fn walk_at_most(root: &Path, depth: usize, wanted: Wanted, most: usize) -> Walk {
    let canonical = resolved(root);
    let name = folder_name(root);
    let wanted = |path: &Path, is_folder| wanted(&name, &slashed(path), is_folder);
    let mut entries = Vec::new();
    let mut faults = Vec::new();
    let mut journals = Vec::new();
    let walk = WalkDir::new(root)
        .follow_links(true)
        .min_depth(1)
        .max_depth(depth);
    let mut walker = walk.into_iter();
    let mut links = Links::default();
    let mut letters = 0;
    while let Some(step) = walker.next() {
        let is_too_much = entries.len() + faults.len() >= most;
        if is_too_much || links.behind >= MOST_LINKED {
            let (most, what) = if is_too_much {
                (most, "")
            } else {
                (MOST_LINKED, " behind links to folders")
            };
            let reason =
                format!("more than {most} files and folders{what}; the rest was not checked");
            let path = step
                .as_ref()
                .map_or(root, |found| found.path().parent().unwrap_or(root));
            faults.push(fault(root, path, WalkFaultKind::Unreadable { reason }));
            break;
        }
        letters += step
            .as_ref()
            .map_or(0, |found| found.path().as_os_str().len());
        if letters > MOST_LETTERS {
            let path = step
                .as_ref()
                .map_or(root, |found| found.path().parent().unwrap_or(root));
            faults.push(fault(
                root,
                path,
                WalkFaultKind::Unreadable {
                    reason: TOO_LONG.to_owned(),
                },
            ));
            break;
        }
        match step {
            Ok(found) if is_hidden(root, &found) && !is_wanted(root, &found, &wanted) => {
                if found
                    .file_name()
                    .as_encoded_bytes()
                    .starts_with(JOURNAL.as_bytes())
                {
                    journals.push(relative(root, found.path()));
                }
                skip_folder(&mut walker, &found);
            }
            Ok(found) if found.path_is_symlink() && leaves(&canonical, found.path()) => {
                faults.push(fault(root, found.path(), WalkFaultKind::LinkLeavesRoot));
                skip_folder(&mut walker, &found);
            }
            Ok(found) => entries.push(Entry {
                link_to: links.meant(&canonical, &found),
                ..entry(root, &found)
            }),
            Err(error) => faults.push(walk_fault(root, &error)),
        }
    }
    entries.sort_by(|a, b| a.path.cmp(&b.path));
    faults.sort_by(|a, b| a.path.cmp(&b.path));
    Walk {
        entries,
        faults,
        journals,
    }
}

fn skip_folder(walker: &mut walkdir::IntoIter, found: &DirEntry) {
    if found.file_type().is_dir() {
        walker.skip_current_dir();
    }
}

/// Whether the name, or that of a folder above it inside the root, begins with a point.
fn is_hidden(root: &Path, found: &DirEntry) -> bool {
    let path = found.path().strip_prefix(root).unwrap_or(found.path());
    path.components()
        .any(|part| part.as_os_str().as_encoded_bytes().first() == Some(&b'.'))
}

/// Links to folders are not followed in hidden places.
fn is_wanted(root: &Path, found: &DirEntry, wanted: &dyn Fn(&Path, bool) -> bool) -> bool {
    let is_folder = found.file_type().is_dir();
    let is_reached = !is_folder || !found.path_is_symlink();
    is_reached && wanted(&relative(root, found.path()), is_folder)
}

/// The folders met so far that are links.
#[derive(Default)]
struct Links {
    folders: BTreeSet<PathBuf>,
    /// How many entries lie behind one.
    behind: usize,
}

impl Links {
    /// The path of a file without the links on the way to it, where there are any; that of a folder
    /// if it is a link.
    fn meant(&mut self, canonical_root: &Path, found: &DirEntry) -> Option<String> {
        let is_link = found.path_is_symlink();
        let (is_folder, is_file) = (found.file_type().is_dir(), found.file_type().is_file());
        if is_link && is_folder {
            self.folders.insert(found.path().to_owned());
        }
        let is_behind_link = !self.folders.is_empty()
            && found.path().ancestors().any(|at| self.folders.contains(at));
        self.behind += usize::from(is_behind_link);
        if !(is_link && is_folder || is_file && (is_link || is_behind_link)) {
            return None;
        }
        let real = fs::canonicalize(found.path()).ok()?;
        Some(slashed(real.strip_prefix(canonical_root).ok()?))
    }
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
        link_to: None,
    }
}

fn walk_fault(root: &Path, error: &walkdir::Error) -> WalkFault {
    let path = error.path().unwrap_or(root);
    let kind = if let Some(ancestor) = error.loop_ancestor() {
        WalkFaultKind::LinkLoop {
            back_to: slashed(&relative(root, ancestor)),
        }
    } else if let Some(back_to) = circle(path) {
        WalkFaultKind::LinkLoop {
            back_to: slashed(&relative(root, &back_to)),
        }
    } else if fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink()) {
        WalkFaultKind::DeadLink {
            to: fs::read_link(path).map_or_else(|_| String::new(), |to| to.display().to_string()),
        }
    } else {
        let reason = error
            .io_error()
            .map_or_else(|| "it cannot be listed".to_owned(), ToString::to_string);
        WalkFaultKind::Unreadable { reason }
    };
    fault(root, path, kind)
}

/// Where links that lead to each other (or to themselves) close the circle.
fn circle(link: &Path) -> Option<PathBuf> {
    let mut at = link.to_owned();
    let mut seen = Vec::new();
    for _ in 0..2 * LONGEST_CHAIN {
        let target = fs::read_link(&at).ok()?;
        at = plain(&at.parent().unwrap_or(Path::new("")).join(target));
        seen.push(at.clone());
    }
    // The second half goes round and round; its first name stands for the whole circle.
    seen.into_iter().skip(LONGEST_CHAIN).min()
}

/// The path without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if plain.file_name().is_some() => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

fn fault(root: &Path, path: &Path, kind: WalkFaultKind) -> WalkFault {
    WalkFault {
        path: slashed(&relative(root, path)),
        kind,
    }
}

fn relative(root: &Path, path: &Path) -> PathBuf {
    path.strip_prefix(root).unwrap_or(path).to_owned()
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    fn nothing(_: &str, _: &str, _: bool) -> bool {
        false
    }

    #[test]
    fn of_hidden_places_only_wanted_files_are_listed() {
        let folder = tempfile::tempdir().unwrap();
        for file in [
            ".git/a.x",
            "b/.c/d.x",
            "b/.c/d.y",
            "b/.e.x",
            "b/.gitignore",
            "b/f",
        ] {
            let path = folder.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        }
        let wanted = |_: &str, path: &str, is_folder: bool| {
            path.starts_with("b/") && (is_folder || path.ends_with(".x"))
        };
        let listed = |wanted| {
            walk(folder.path(), usize::MAX, wanted)
                .entries
                .into_iter()
                .map(|entry| entry.path)
        };
        assert_eq!(listed(nothing).collect::<Vec<_>>(), ["b", "b/f"]);
        assert_eq!(
            listed(wanted).collect::<Vec<_>>(),
            ["b", "b/.c", "b/.c/d.x", "b/.e.x", "b/f"]
        );
    }

    #[test]
    fn a_link_and_what_is_behind_it_are_known_as_what_they_lead_to() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("real")).unwrap();
        fs::write(folder.path().join("real/file"), "").unwrap();
        symlink("real", folder.path().join("linked")).unwrap();
        symlink("real/file", folder.path().join("one")).unwrap();
        let entries = walk(folder.path(), usize::MAX, nothing).entries;
        let links: Vec<_> = entries
            .iter()
            .filter_map(|entry| Some((&*entry.path, entry.link_to.as_deref()?)))
            .collect();
        assert_eq!(
            links,
            [
                ("linked", "real"),
                ("linked/file", "real/file"),
                ("one", "real/file")
            ]
        );
    }

    fn faults(root: &Path) -> Vec<(String, WalkFaultKind)> {
        walk(root, usize::MAX, nothing)
            .faults
            .into_iter()
            .map(|fault| (fault.path, fault.kind))
            .collect()
    }

    #[test]
    fn loops_of_every_kind_end() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        fs::create_dir(root.join("a")).unwrap();
        symlink("..", root.join("a/up")).unwrap();
        symlink("self", root.join("self")).unwrap();
        symlink("two", root.join("one")).unwrap();
        symlink("one", root.join("two")).unwrap();
        let found = faults(root);
        let loops: Vec<_> = found.iter().map(|(path, _)| path.as_str()).collect();
        assert_eq!(loops, ["a/up", "one", "self", "two"]);
        assert!(
            found
                .iter()
                .all(|(_, kind)| matches!(kind, WalkFaultKind::LinkLoop { .. })),
            "{found:?}"
        );
    }

    #[test]
    fn broken_and_leaving_links_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path().join("root");
        fs::create_dir(&root).unwrap();
        symlink("nowhere", root.join("broken")).unwrap();
        symlink("..", root.join("out")).unwrap();
        let broken = WalkFaultKind::DeadLink {
            to: "nowhere".to_owned(),
        };
        let expected = [
            ("broken".to_owned(), broken),
            ("out".to_owned(), WalkFaultKind::LinkLeavesRoot),
        ];
        assert_eq!(faults(&root), expected);
    }

    #[test]
    fn a_root_that_is_a_link_is_followed() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("real")).unwrap();
        fs::write(folder.path().join("real/file"), "").unwrap();
        symlink("real", folder.path().join("data")).unwrap();
        let Walk {
            entries, faults, ..
        } = walk(&folder.path().join("data"), usize::MAX, nothing);
        assert_eq!((entries.len(), faults), (1, Vec::new()));
    }

    #[test]
    fn folders_that_link_to_each_other_are_cut_off() {
        let folder = tempfile::tempdir().unwrap();
        let names = ["a", "b", "c", "d", "e", "f", "g"];
        for name in names {
            fs::create_dir(folder.path().join(name)).unwrap();
            for other in names {
                symlink(format!("../{other}"), folder.path().join(name).join(other)).unwrap();
            }
        }
        let Walk {
            entries, faults, ..
        } = walk_at_most(folder.path(), usize::MAX, nothing, 500);
        assert!(entries.len() <= 500);
        assert!(
            faults
                .iter()
                .any(|fault| matches!(&fault.kind, WalkFaultKind::Unreadable { reason } if reason.contains("500")))
        );
    }
}
