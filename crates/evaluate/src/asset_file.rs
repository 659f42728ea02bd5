//! An asset with its OBJ, read alone.

use std::path::{Path, PathBuf};

use super::Error;
use super::files::{read_text, shown};
use mhlint_diag::Application;
use mhlint_eval::vector::Point;
use mhlint_formats::mhclo::{self, Clothes, Reader, Stopped};
use mhlint_formats::obj;

/// The files of an asset.
#[derive(Debug, Clone)]
pub(super) struct AssetFile {
    pub(super) path: String,
    pub(super) clothes: Clothes,
    pub(super) obj_path: PathBuf,
    pub(super) positions: Vec<Point>,
}

/// Reads an asset as an application does.
///
/// # Errors
/// Files that cannot be read, and lines that stop the application.
pub(super) fn read(
    path: &Path,
    application: Application,
    reader: &'static Reader,
) -> Result<AssetFile, Error> {
    let clothes = mhclo::parse(&read_text(path)?, None);
    if let Some(stop) = reader.of(&clothes).stop() {
        let Stopped {
            line,
            exception,
            reason,
        } = stop;
        let reason = format!("`{}`, line {line}: {reason}", shown(path));
        return Err(Error::Stops {
            application,
            exception,
            reason,
        });
    }
    let name = reader.of(&clothes).last("obj_file");
    let name = name.ok_or_else(|| Error::file(shown(path), "it has no `obj_file` line"))?;
    let obj_path = path.parent().unwrap_or(Path::new("")).join(name.word());
    let mesh = obj::parse(&read_text(&obj_path)?);
    if let Some(bad) = mesh.facts.unreadable.first() {
        return Err(Error::file(
            shown(&obj_path),
            format!("line {}: {}", bad.line, bad.what),
        ));
    }
    Ok(AssetFile {
        path: shown(path),
        positions: mesh.positions,
        clothes,
        obj_path,
    })
}
