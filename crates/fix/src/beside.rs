//! A new content for a file, which never stands there half written.
//!
//! It goes to a hidden file in the same folder and takes the place of the old one by renaming.
//! Killed at any moment, the file is whole, the old or the new one.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile, TempPath};

use super::pending::Pending;
use mhlint_source::{folder_of, link_targets};

/// A content that waits beside its file; goes away if it is not used.
#[derive(Debug)]
pub(super) struct Beside {
    file: PathBuf,
    content: TempPath,
    pending: Pending,
}

impl Beside {
    /// Writes the content, with owner and permissions of the file that is there already. The name
    /// is hidden, so that no walk over the data takes it for an asset should a killed run leave it
    /// behind.
    pub(super) fn write(file: PathBuf, bytes: &[u8], pending: &Pending) -> io::Result<Self> {
        let make = || {
            Builder::new()
                .prefix(".mhlint-")
                .make_in(folder_of(&file), |path| File::create_new(path))
        };
        Self::fill(pending.make(make)?, file, bytes, pending)
    }

    /// The same under a name that is written down before.
    pub(super) fn write_as(
        name: &Path,
        file: PathBuf,
        bytes: &[u8],
        pending: &Pending,
    ) -> io::Result<Self> {
        let make = || {
            Ok(NamedTempFile::from_parts(
                File::create_new(name)?,
                TempPath::try_from_path(name)?,
            ))
        };
        Self::fill(pending.make(make)?, file, bytes, pending)
    }

    fn fill(
        mut beside: NamedTempFile,
        file: PathBuf,
        bytes: &[u8],
        pending: &Pending,
    ) -> io::Result<Self> {
        beside.as_file_mut().write_all(bytes)?;
        if let Ok(before) = fs::metadata(&file) {
            keep_owner(&before, beside.path());
            beside.as_file().set_permissions(before.permissions())?;
        }
        beside.as_file().sync_all()?;
        Ok(Self {
            file,
            content: beside.into_temp_path(),
            pending: pending.clone(),
        })
    }

    /// The content becomes that of the file.
    pub(super) fn take_place(self) -> io::Result<()> {
        let Self {
            file,
            content,
            pending,
        } = self;
        let name = content.to_path_buf();
        pending
            .done(&name, || content.persist(&file))
            .map_err(|refused| refused.error)?;
        sync_folder(&file);
        Ok(())
    }
}

/// Replaces a file as a whole, or makes it. A link is followed, also to where nothing is yet; a
/// device or pipe has no place to take and is written to as it is.
///
/// # Errors
/// What the operating system says. Then the file is as it was.
pub fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let pending = Pending::default();
    match fs::metadata(file) {
        Ok(before) if !before.is_file() => fs::OpenOptions::new()
            .write(true)
            .open(file)?
            .write_all(bytes),
        Ok(_) => Beside::write(fs::canonicalize(file)?, bytes, &pending)?.take_place(),
        // What a link leads to may not be there yet.
        Err(error) => match link_targets(file).pop() {
            Some(end) if end.is_symlink() => Err(error),
            Some(end) => Beside::write(end, bytes, &pending)?.take_place(),
            None => Beside::write(file.to_owned(), bytes, &pending)?.take_place(),
        },
    }
}

/// Owner and group stay where that is allowed; only an administrator changes files of others.
#[cfg(unix)]
fn keep_owner(before: &fs::Metadata, beside: &Path) {
    use std::os::unix::fs::{MetadataExt, chown};
    let _ = chown(beside, Some(before.uid()), Some(before.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_: &fs::Metadata, _: &Path) {}

/// The new name is on disk only when its folder is. Where folders cannot be opened, the system sees
/// to it.
pub(super) fn sync_folder(file: &Path) {
    if let Ok(folder) = File::open(folder_of(file)) {
        let _ = folder.sync_all();
    }
}
