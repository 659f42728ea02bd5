//! Where reports go: standard output or a file, which is either replaced as a whole or left alone.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::args::not_one_of;
use super::exit::Failure;
use crate::report::Format;

/// `FORMAT[=FILE]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Target {
    /// How.
    pub(super) format: Format,
    /// Where to, standard output if none.
    pub(super) file: Option<PathBuf>,
}

impl Target {
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let (name, file) = text.split_once('=').map_or((text, None), |(name, file)| (name, Some(file)));
        let known: Vec<&str> = Format::ALL.iter().map(|(name, _)| *name).collect();
        let found = Format::ALL.iter().find(|(known, _)| *known == name);
        let (_, format) = found.ok_or_else(|| not_one_of("report format", name, &known))?;
        if file == Some("") {
            return Err(format!("a file is wanted behind `=`, `{name}=report.txt` say"));
        }
        Ok(Self { format: *format, file: file.map(PathBuf::from) })
    }
}

/// The reports to write, `human` to standard output if none was asked for. Refuses before the run what
/// could not be written after it.
pub(super) fn targets(asked: &[Target]) -> Result<Vec<Target>, Failure> {
    if asked.is_empty() {
        return Ok(vec![Target { format: Format::Human, file: None }]);
    }
    let to_stdout = asked.iter().filter(|target| target.file.is_none()).count();
    if to_stdout > 1 {
        return Err(Failure::Usage(format!(
            "{to_stdout} reports to standard output would run into each other; give all but one a file: --report FORMAT=FILE"
        )));
    }
    let files: Vec<&PathBuf> = asked.iter().filter_map(|target| target.file.as_ref()).collect();
    files.iter().try_for_each(|file| refuse_unwritable("a report", file))?;
    let mut places: Vec<PathBuf> = files.into_iter().map(|file| whole(file)).collect();
    places.sort_unstable();
    if let Some(twice) = places.windows(2).find(|pair| pair.first() == pair.last()).and_then(<[_]>::first) {
        return Err(Failure::Usage(format!("two reports to `{}`; give each its own file", twice.display())));
    }
    Ok(asked.to_vec())
}

/// Refuses a file that `what` could not be written to.
pub(super) fn refuse_unwritable(what: &str, file: &Path) -> Result<(), Failure> {
    let shown = file.display();
    if file.is_dir() {
        return Err(Failure::Usage(format!("cannot write {what} to `{shown}`: it is a folder; name a file in it")));
    }
    let parent = folder_of(file);
    if !parent.is_dir() {
        let folder = parent.display();
        return Err(Failure::Usage(format!(
            "cannot write {what} to `{shown}`: there is no folder `{folder}`; make it first"
        )));
    }
    Ok(())
}

/// The same for every way to write a path.
fn whole(file: &Path) -> PathBuf {
    let folder = fs::canonicalize(folder_of(file)).unwrap_or_default();
    fs::canonicalize(file).unwrap_or_else(|_| folder.join(file.file_name().unwrap_or_default()))
}

fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Writes a report to a file.
pub(super) fn write_file(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let shown = file.display();
    replace(file, bytes).map_err(|error| {
        let remedy = remedy(&error);
        Failure::Usage(format!("cannot write the report to `{shown}`: {error}; {remedy}"))
    })
}

/// What to do about a write that failed.
pub(super) fn remedy(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "make room or name a file on another disk",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "name a file in a folder that you may write to"
        }
        io::ErrorKind::BrokenPipe => "nobody reads it any more; keep the reader running or name a file",
        _ => "name another file",
    }
}

/// Writes beside the file first and then takes its place, so that nobody ever sees half a result. A link is
/// followed; a device or pipe has no place to take and is written to as it is.
pub(super) fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let before = fs::metadata(file).ok();
    if before.as_ref().is_some_and(|before| !before.is_file()) {
        return fs::OpenOptions::new().write(true).open(file)?.write_all(bytes);
    }
    let file = if before.is_some() { fs::canonicalize(file)? } else { file.to_owned() };
    let (beside, mut handle) = create_beside(&file)?;
    let written = handle
        .write_all(bytes)
        .and_then(|()| before.map_or(Ok(()), |before| handle.set_permissions(before.permissions())))
        .and_then(|()| handle.sync_all());
    drop(handle);
    written.and_then(|()| fs::rename(&beside, &file)).inspect_err(|_| {
        // The error of the write is the one to tell; the remains may not exist at all.
        let _ = fs::remove_file(&beside);
    })
}

/// A new file in the same folder. Its name may be taken by what a killed run left behind.
fn create_beside(file: &Path) -> io::Result<(PathBuf, fs::File)> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let mut number = std::process::id();
    loop {
        let beside = folder_of(file).join(format!(".{name}.{number}.tmp"));
        match fs::OpenOptions::new().write(true).create_new(true).open(&beside) {
            Ok(handle) => return Ok((beside, handle)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number = number.wrapping_add(1),
            Err(error) => return Err(error),
        }
    }
}
