//! The journal of a run that fixes: which hidden files it is about to make beside the data.
//!
//! It lies in the folder that is fixed, locked as long as the run lives. One that is killed leaves
//! it there, and a later run finds in it what may go. Whoever can put a journal into a repository
//! can have nothing removed with it but hidden files of that name in there.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

use tempfile::{Builder, TempPath};

use super::pending::Pending;
use mhlint_source::{JOURNAL, folder_of};

/// What a journal begins with; a zero is behind it and each path.
const FORMAT: &[u8] = b"mhlint-journal/1";

/// What the names of new contents begin with.
const CONTENT: &str = ".mhlint-";

/// Journals are short: a path for each file that is fixed.
const MOST_BYTES: u64 = 64 << 20;

/// The journal of this run in one folder; goes away when all is done.
pub(super) struct Journal {
    names: std::vec::IntoIter<PathBuf>,
    file: TempPath,
    pending: Pending,
    /// Locked until it is closed.
    _lock: File,
}

impl Journal {
    /// Writes down the names of the contents that are to wait beside `files`, which lie in `root`.
    /// Nothing else of them is made.
    pub(super) fn open<'f>(
        root: &Path,
        files: impl Iterator<Item = &'f Path>,
        pending: &Pending,
    ) -> io::Result<Self> {
        let root = fs::canonicalize(root)?;
        let made = pending.make(|| {
            Builder::new()
                .prefix(JOURNAL)
                .make_in(&root, |path| File::create_new(path))
        })?;
        let (mut lock, file) = made.into_parts();
        // Where files cannot be locked, nobody can tell that this run is gone, and nobody removes
        // what it leaves.
        let _ = lock.lock();
        let id = id(&file).unwrap_or_default();
        let name = |(at, file): (usize, &Path)| folder_of(file).join(format!("{CONTENT}{id}-{at}"));
        let names: Vec<PathBuf> = files.enumerate().map(name).collect();
        let mut text = FORMAT.to_vec();
        for name in &names {
            text.push(0);
            text.extend(
                name.strip_prefix(&root)
                    .unwrap_or(name)
                    .as_os_str()
                    .as_encoded_bytes(),
            );
        }
        lock.write_all(&text)?;
        lock.sync_all()?;
        Ok(Self {
            names: names.into_iter(),
            file,
            pending: pending.clone(),
            _lock: lock,
        })
    }

    /// The name of the content for the next of the files.
    pub(super) fn next_name(&mut self) -> Option<PathBuf> {
        self.names.next()
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        self.pending.done(&self.file, || {
            fs::remove_file(&self.file).unwrap_or_default();
        });
    }
}

/// Whether a file is the journal of some run.
pub(super) fn is_journal(path: &Path) -> bool {
    id(path).is_some()
}

/// What tells one journal from another.
fn id(journal: &Path) -> Option<String> {
    Some(
        journal
            .file_name()?
            .to_str()?
            .strip_prefix(JOURNAL)?
            .to_owned(),
    )
    .filter(|id| !id.is_empty())
}

/// What a run that is gone left in a folder.
#[derive(Debug)]
pub struct Left {
    journal: PathBuf,
    files: Vec<PathBuf>,
    /// Locked, so that no other run removes the same.
    _lock: File,
}

impl Left {
    /// What the journal at a path names, if the run that wrote it is gone.
    pub fn by(journal: &Path) -> Option<Self> {
        let is_file = |path: &Path| fs::symlink_metadata(path).is_ok_and(|found| found.is_file());
        let id = id(journal).filter(|_| is_file(journal))?;
        let mut lock = File::open(journal).ok()?;
        lock.try_lock().ok()?;
        let mut text = Vec::new();
        Read::by_ref(&mut lock)
            .take(MOST_BYTES)
            .read_to_end(&mut text)
            .ok()?;
        // One that was killed at its first line has made nothing else.
        let named = text
            .strip_prefix(FORMAT)
            .unwrap_or_default()
            .split(|byte| *byte == 0)
            .skip(1);
        let root = fs::canonicalize(folder_of(journal)).ok()?;
        let files = named
            .filter_map(|rel| place(&root, &id, native(rel)?))
            .filter(|file| is_file(file))
            .collect();
        Some(Self {
            journal: journal.to_owned(),
            files,
            _lock: lock,
        })
    }

    /// The folder that was fixed.
    pub fn folder(&self) -> &Path {
        folder_of(&self.journal)
    }

    /// How many hidden files are left.
    pub const fn count(&self) -> usize {
        self.files.len() + 1
    }

    /// Removes them, the journal last.
    ///
    /// # Errors
    /// What the operating system says.
    pub fn remove(&self) -> io::Result<()> {
        self.files
            .iter()
            .chain([&self.journal])
            .try_for_each(fs::remove_file)
    }
}

/// Where a content lies that a journal names; none that is called otherwise, or lies elsewhere.
fn place(root: &Path, id: &str, rel: PathBuf) -> Option<PathBuf> {
    let is_below = rel
        .components()
        .all(|part| matches!(part, Component::Normal(_)));
    let number = rel
        .file_name()?
        .to_str()?
        .strip_prefix(CONTENT)?
        .strip_prefix(id)?
        .strip_prefix('-')?;
    let is_own = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    let file = root.join(rel);
    let is_inside =
        || fs::canonicalize(folder_of(&file)).is_ok_and(|folder| folder.starts_with(root));
    (is_below && is_own && is_inside()).then_some(file)
}

#[cfg(unix)]
#[expect(
    clippy::unnecessary_wraps,
    reason = "elsewhere a path has to be a text"
)]
fn native(path: &[u8]) -> Option<PathBuf> {
    use std::os::unix::ffi::OsStringExt;
    Some(OsString::from_vec(path.to_vec()).into())
}

#[cfg(not(unix))]
fn native(path: &[u8]) -> Option<PathBuf> {
    Some(OsString::from(std::str::from_utf8(path).ok()?).into())
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    /// A folder with a journal that names these paths.
    fn left(named: &[&str]) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let journal = folder.path().join(format!("{JOURNAL}abc"));
        fs::write(&journal, [&["mhlint-journal/1"], named].concat().join("\0")).unwrap();
        (folder, journal)
    }

    #[test]
    fn a_journal_is_that_of_a_run_until_it_is_gone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        fs::write(&file, "x").unwrap();
        let pending = Pending::default();
        let mut journal =
            Journal::open(folder.path(), [file.as_path()].into_iter(), &pending).unwrap();
        let path = journal.file.to_path_buf();
        let name = journal.next_name().unwrap();
        fs::write(&name, "new").unwrap();
        assert!(Left::by(&path).is_none(), "the run is alive");
        let copy = folder
            .path()
            .join(format!("{JOURNAL}{}", id(&path).unwrap().to_uppercase()));
        fs::copy(&path, &copy).unwrap();
        drop(journal);
        assert!(!path.exists());
        // The copy has another name, so what it names is not its own.
        assert_eq!(Left::by(&copy).map(|left| left.count()), Some(1));
        fs::rename(&copy, &path).unwrap();
        let left = Left::by(&path).unwrap();
        assert_eq!((left.count(), left.folder()), (2, folder.path()));
        left.remove().unwrap();
        assert!(!name.exists() && !path.exists() && file.exists());
    }

    #[test]
    fn nothing_goes_but_hidden_files_of_the_journal_inside() {
        let (folder, journal) = left(&[
            "data",
            ".mhlint-other-0",
            "../.mhlint-abc-0",
            "link/.mhlint-abc-1",
            ".mhlint-abc-x",
            ".mhlint-abc-2",
        ]);
        let outside = tempfile::tempdir().unwrap();
        symlink(outside.path(), folder.path().join("link")).unwrap();
        for name in [
            "data",
            ".mhlint-other-0",
            ".mhlint-abc-x",
            ".mhlint-abc-2",
            "link/.mhlint-abc-1",
        ] {
            fs::write(folder.path().join(name), "x").unwrap();
        }
        Left::by(&journal).unwrap().remove().unwrap();
        let mut names: Vec<_> = fs::read_dir(folder.path())
            .unwrap()
            .map(|one| one.unwrap().file_name())
            .collect();
        names.sort();
        assert_eq!(names, [".mhlint-abc-x", ".mhlint-other-0", "data", "link"]);
        assert!(outside.path().join(".mhlint-abc-1").exists());
    }

    #[test]
    fn what_is_no_journal_is_left_alone() {
        let (folder, journal) = left(&[]);
        fs::write(&journal, "mhlint-jour").unwrap();
        assert_eq!(
            Left::by(&journal).unwrap().count(),
            1,
            "killed at its first line"
        );
        let link = folder.path().join(format!("{JOURNAL}link"));
        symlink(&journal, &link).unwrap();
        assert!(Left::by(&link).is_none());
        assert!(Left::by(&folder.path().join("other")).is_none());
    }
}
