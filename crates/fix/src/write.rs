//! Changes to disk: every file is replaced as a whole, and all are prepared before the first is.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use xxhash_rust::xxh3::xxh3_64;

use super::beside::{Beside, sync_folder};
use super::journal::Journal;
use super::pending::Pending;

/// A file before and after.
#[derive(Debug, Clone)]
pub struct FileChange {
    /// Path as reports print it.
    pub path: String,
    /// Where it is.
    pub file: PathBuf,
    /// The folder that it must not lie outside of.
    pub root: PathBuf,
    /// Hash of the bytes that were checked.
    pub checked: u64,
    /// The bytes that were checked.
    pub before: Vec<u8>,
    /// The new bytes; `None` for a file that goes away.
    pub after: Option<Vec<u8>>,
}

/// Why nothing was changed, or not everything.
#[derive(Debug)]
pub struct WriteError {
    /// The file.
    pub path: String,
    /// What was in the way.
    pub reason: Reason,
}

/// What keeps a file from being changed.
#[derive(Debug)]
pub enum Reason {
    /// Not the bytes that were checked.
    ChangedMeanwhile,
    /// May not be written to.
    ReadOnly,
    /// A link leads out of the folder that was checked.
    LeavesRoot,
    /// No regular file.
    NoFile,
    /// What the operating system says.
    Io(io::Error),
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot change `{}`: ", self.path)?;
        match &self.reason {
            Reason::ChangedMeanwhile => {
                f.write_str("it changed during the check; run mhlint again")
            }
            Reason::ReadOnly => {
                f.write_str("it is read-only; make it writable, or use PATHs without it")
            }
            Reason::LeavesRoot => f.write_str(
                "a link leads out of the data folder; run mhlint on the folder that it leads to",
            ),
            Reason::NoFile => f.write_str("it is not a regular file; use PATHs without it"),
            Reason::Io(error) => write!(f, "{error}; {}", remedy(error)),
        }
    }
}

impl std::error::Error for WriteError {}

/// What to do about a change that the operating system refuses. The new file waits beside the old
/// one.
fn remedy(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "free some disk space",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "make its folder writable, or use PATHs without it"
        }
        _ => "run mhlint again, or use PATHs without it",
    }
}

/// A change that waits to be done.
struct Prepared<'c> {
    change: &'c FileChange,
    /// The file itself, behind all links.
    file: PathBuf,
    /// The new content; `None` for a file that goes away.
    beside: Option<Beside>,
}

/// Writes all changes. Contents come first, files go away last. What is made on the way is noted in
/// `pending`, and in a journal in each folder that is fixed.
///
/// # Errors
/// The first file that cannot be changed. Then nothing was, unless the operating system refused a
/// step that it had allowed a moment before.
pub fn write_all(changes: &[FileChange], pending: &Pending) -> Result<(), WriteError> {
    let mut by_root: BTreeMap<&Path, Vec<(&FileChange, PathBuf)>> = BTreeMap::new();
    for change in changes {
        let file = changeable(change).map_err(|reason| failed(change, reason))?;
        by_root
            .entry(&change.root)
            .or_default()
            .push((change, file));
    }
    let (mut journals, mut prepared) = (Vec::new(), Vec::new());
    for (root, files) in by_root {
        let kept = files
            .iter()
            .filter(|(change, _)| change.after.is_some())
            .map(|(_, file)| file.as_path());
        // The folder may be closed although its files may be changed. Then a run that is killed
        // leaves what nobody names.
        let mut journal = Journal::open(root, kept, pending).ok();
        for (change, file) in files {
            let beside = content(change, &file, journal.as_mut(), pending);
            let beside = beside.map_err(|error| failed(change, Reason::Io(error)))?;
            prepared.push(Prepared {
                change,
                file,
                beside,
            });
        }
        journals.push(journal);
    }
    prepared.sort_by_key(|one| one.beside.is_none());
    for Prepared {
        change,
        file,
        beside,
    } in prepared
    {
        refuse_changed(&file, change.checked).map_err(|reason| failed(change, reason))?;
        let done = match beside {
            Some(beside) => beside.take_place(),
            None => fs::remove_file(&file).inspect(|()| sync_folder(&file)),
        };
        done.map_err(|error| failed(change, Reason::Io(error)))?;
    }
    Ok(())
}

fn failed(change: &FileChange, reason: Reason) -> WriteError {
    WriteError {
        path: change.path.clone(),
        reason,
    }
}

/// The file of a change, if nothing keeps it from being changed.
fn changeable(change: &FileChange) -> Result<PathBuf, Reason> {
    let file = real_file(change)?;
    if fs::metadata(&file)
        .map_err(Reason::Io)?
        .permissions()
        .readonly()
    {
        return Err(Reason::ReadOnly);
    }
    refuse_changed(&file, change.checked)?;
    Ok(file)
}

/// Writes the new content beside the file, if it has one.
fn content(
    change: &FileChange,
    file: &Path,
    journal: Option<&mut Journal>,
    pending: &Pending,
) -> io::Result<Option<Beside>> {
    let Some(bytes) = &change.after else {
        return Ok(None);
    };
    match journal.and_then(Journal::next_name) {
        Some(name) => Beside::write_as(&name, file.to_owned(), bytes, pending).map(Some),
        None => Beside::write(file.to_owned(), bytes, pending).map(Some),
    }
}

/// The file behind all links, inside the root.
fn real_file(change: &FileChange) -> Result<PathBuf, Reason> {
    let file = fs::canonicalize(&change.file).map_err(Reason::Io)?;
    let root = fs::canonicalize(&change.root).map_err(Reason::Io)?;
    if !file.starts_with(root) {
        return Err(Reason::LeavesRoot);
    }
    if file.is_file() {
        Ok(file)
    } else {
        Err(Reason::NoFile)
    }
}

fn refuse_changed(file: &Path, checked: u64) -> Result<(), Reason> {
    let bytes = fs::read(file).map_err(Reason::Io)?;
    if xxh3_64(&bytes) == checked {
        Ok(())
    } else {
        Err(Reason::ChangedMeanwhile)
    }
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    fn change(root: &Path, name: &str, before: &str, after: Option<&str>) -> FileChange {
        FileChange {
            path: name.to_owned(),
            file: root.join(name),
            root: root.to_owned(),
            checked: xxh3_64(before.as_bytes()),
            before: before.as_bytes().to_vec(),
            after: after.map(|text| text.as_bytes().to_vec()),
        }
    }

    fn written(changes: &[FileChange]) -> Result<(), WriteError> {
        write_all(changes, &Pending::default())
    }

    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        files
            .iter()
            .for_each(|(name, text)| fs::write(folder.path().join(name), text).unwrap());
        folder
    }

    fn content(root: &Path) -> Vec<(String, String)> {
        let entries = fs::read_dir(root)
            .unwrap()
            .map(|entry| entry.unwrap().path());
        let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
        let mut all: Vec<_> = entries
            .map(|path| (name(&path), fs::read_to_string(&path).unwrap()))
            .collect();
        all.sort();
        all
    }

    fn texts(files: &[(&str, &str)]) -> Vec<(String, String)> {
        files
            .iter()
            .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
            .collect()
    }

    #[test]
    fn files_are_replaced_and_removed_and_keep_their_mode() {
        let folder = folder(&[("a", "old"), ("b", "gone")]);
        let root = folder.path();
        fs::set_permissions(root.join("a"), fs::Permissions::from_mode(0o640)).unwrap();
        written(&[
            change(root, "b", "gone", None),
            change(root, "a", "old", Some("new")),
        ])
        .unwrap();
        assert_eq!(content(root), texts(&[("a", "new")]));
        assert_eq!(
            fs::metadata(root.join("a")).unwrap().permissions().mode() & 0o777,
            0o640
        );
    }

    #[test]
    fn one_file_in_the_way_leaves_all_as_they_were() {
        let before = [("a", "old"), ("b", "other")];
        let folder = folder(&before);
        let root = folder.path();
        let first = change(root, "a", "old", Some("new"));
        let changed =
            written(&[first.clone(), change(root, "b", "judged", Some("x"))]).unwrap_err();
        assert!(
            changed
                .to_string()
                .contains("`b`: it changed during the check"),
            "{changed}"
        );
        fs::set_permissions(root.join("b"), fs::Permissions::from_mode(0o444)).unwrap();
        let read_only = written(&[first, change(root, "b", "other", Some("x"))]).unwrap_err();
        assert!(
            read_only.to_string().contains("`b`: it is read-only"),
            "{read_only}"
        );
        assert_eq!(content(root), texts(&before));
    }

    #[test]
    fn a_refusal_names_a_remedy() {
        let refused = |kind: io::ErrorKind| {
            WriteError {
                path: "a".to_owned(),
                reason: Reason::Io(io::Error::from(kind)),
            }
            .to_string()
        };
        assert!(refused(io::ErrorKind::PermissionDenied).contains("; make its folder writable"));
        assert!(refused(io::ErrorKind::StorageFull).contains("; free some disk space"));
    }

    #[test]
    fn links_are_followed_inside_the_root_only() {
        let folder = folder(&[("outside", "old")]);
        let root = folder.path().join("root");
        fs::create_dir(&root).unwrap();
        fs::write(root.join("a"), "old").unwrap();
        symlink("a", root.join("link")).unwrap();
        symlink("../outside", root.join("out")).unwrap();
        written(&[change(&root, "link", "old", Some("new"))]).unwrap();
        assert!(
            fs::symlink_metadata(root.join("link"))
                .unwrap()
                .is_symlink()
        );
        assert_eq!(fs::read_to_string(root.join("a")).unwrap(), "new");
        let leaves = written(&[change(&root, "out", "old", Some("new"))]).unwrap_err();
        assert!(
            leaves.to_string().contains("leads out of the data folder"),
            "{leaves}"
        );
        assert_eq!(
            fs::read_to_string(folder.path().join("outside")).unwrap(),
            "old"
        );
    }
}
