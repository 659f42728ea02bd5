//! Results to a file or to standard output.

use std::io::Write;
use std::path::Path;

use super::args::MeshOutput;
use crate::cli::exit::Failure;
use crate::cli::output::{refuse_unwritable, write_file};
use mhlint_evaluate::Error;

/// Writes to `file`, or to `out` without one.
pub(super) fn write(bytes: &[u8], file: Option<&Path>, out: &mut dyn Write) -> Result<(), Failure> {
    match file {
        Some(file) => {
            refuse_unwritable("the result", file)?;
            write_file("the result", file, bytes)
        }
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
