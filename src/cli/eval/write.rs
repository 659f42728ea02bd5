//! Results to a file or to standard output.

use std::io::Write;
use std::path::Path;

use super::args::MeshOutput;
use crate::cli::exit::Failure;
use crate::engine::evaluate::Error;
use crate::fix::replace;

/// Writes to `file`, or to `out` without one.
pub(super) fn write(bytes: &[u8], file: Option<&Path>, out: &mut dyn Write) -> Result<(), Failure> {
    match file {
        Some(file) => write_file(file, bytes),
        None => Ok(out.write_all(bytes)?),
    }
}

/// Writes a mesh as asked for: `obj` or `json`, whichever is wanted.
pub(super) fn write_mesh(
    output: &MeshOutput,
    obj: impl FnOnce() -> Result<Vec<u8>, Error>,
    json: impl FnOnce() -> Result<Vec<u8>, Error>,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let bytes = if output.is_json() { json()? } else { obj()? };
    write(&bytes, output.output.as_deref(), out)
}

fn write_file(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let fault = |reason: String| {
        let path = file.display().to_string();
        Failure::Eval(Error::File { path, reason: format!("not written: {reason}") })
    };
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return Err(fault(format!("there is no folder `{}`; make it first", folder.display())));
    }
    if file.file_name().is_none() || file.is_dir() {
        return Err(fault("it is a folder; name a file in it".to_owned()));
    }
    replace(file, bytes).map_err(|error| fault(error.to_string()))
}
