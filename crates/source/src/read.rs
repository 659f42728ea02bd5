//! Bytes of single files on disk, never more than the limit.

use std::fs;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

use super::Limits;
use super::tree::{Ends, ReadFault};

/// The bytes of a single file that no listing is needed for.
///
/// # Errors
/// As `Tree::read`.
pub fn read_file(path: &Path, limits: &Limits) -> Result<Vec<u8>, ReadFault> {
    let metadata = fs::metadata(path).map_err(|error| ReadFault::Unreadable(error.to_string()))?;
    if metadata.is_dir() {
        return Err(ReadFault::Unreadable("it is a folder".to_owned()));
    }
    if !metadata.is_file() {
        return Err(ReadFault::Unreadable("it is not a regular file".to_owned()));
    }
    if metadata.len() > limits.file_bytes {
        return Err(too_large(metadata.len(), limits));
    }
    read_bounded(path, metadata.len(), limits)
}

pub(super) fn ends_of(path: &Path, head: usize, tail: usize) -> io::Result<Ends> {
    let mut file = fs::File::open(path)?;
    let (mut first, mut last) = (Vec::with_capacity(head), Vec::with_capacity(tail));
    file.by_ref().take(head as u64).read_to_end(&mut first)?;
    // A file may have become shorter since it was listed.
    let end = file.metadata()?.len().saturating_sub(tail as u64);
    file.seek(SeekFrom::Start(end))?;
    file.take(tail as u64).read_to_end(&mut last)?;
    Ok((first, last))
}

pub(super) fn read_bounded(
    path: &Path,
    expected: u64,
    limits: &Limits,
) -> Result<Vec<u8>, ReadFault> {
    let unreadable = |error: io::Error| ReadFault::Unreadable(error.to_string());
    let file = fs::File::open(path).map_err(unreadable)?;
    let mut bytes = Vec::with_capacity(usize::try_from(expected).unwrap_or(0).saturating_add(1));
    // A file may grow while it is read; the limit holds all the same.
    file.take(limits.file_bytes.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() as u64 > limits.file_bytes {
        return Err(too_large(bytes.len() as u64, limits));
    }
    Ok(bytes)
}

pub(super) fn too_large(size: u64, limits: &Limits) -> ReadFault {
    ReadFault::TooLarge {
        size,
        limit: limits.file_bytes,
    }
}
