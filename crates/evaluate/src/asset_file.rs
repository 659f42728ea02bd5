//! An asset with its OBJ, read alone.

use std::path::{Path, PathBuf};

use super::Error;
use super::files::{read_text, shown};
use mhlint_diag::Application;
use mhlint_eval::vector::Point;
use mhlint_formats::mhclo::{self, Clothes, Entry, FaultKind};
use mhlint_formats::obj;

/// The files of an asset.
#[derive(Debug, Clone)]
pub(super) struct AssetFile {
    pub(super) path: String,
    pub(super) clothes: Clothes,
    pub(super) obj_path: PathBuf,
    pub(super) positions: Vec<Point>,
}

/// Reads an asset as an application does, which takes lines of which `counts` holds.
///
/// # Errors
/// Files that cannot be read, and lines that stop the application.
pub(super) fn read(
    path: &Path,
    application: Application,
    counts: fn(&Entry) -> bool,
) -> Result<AssetFile, Error> {
    let clothes = mhclo::parse(&read_text(path)?, None);
    let stops_at = clothes.faults.first(|fault| stop(fault.kind));
    if let Some((line, (exception, reason))) = stops_at {
        let reason = format!("`{}`, line {line}: {reason}", shown(path));
        return Err(Error::Stops {
            application,
            exception,
            reason,
        });
    }
    let name = clothes.all("obj_file").rev().find(|entry| counts(entry));
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

/// The exception at such a line, and why; `None` where the loader goes on without it.
fn stop(kind: FaultKind) -> Option<(&'static str, String)> {
    let (exception, reason) = match kind {
        FaultKind::FieldCount(count) => {
            return Some((
                "IndexError",
                format!("a vertex line needs 1, 6 or at least 9 words, but has {count}"),
            ));
        }
        FaultKind::ShortScale => ("IndexError", "the values of a keyword are missing"),
        FaultKind::RowWord | FaultKind::ScaleWord | FaultKind::NotWhole => {
            ("ValueError", "a word is not a number")
        }
        FaultKind::DeleteWord => (
            "ValueError",
            "a word in the list of vertices to delete is not a number",
        ),
        FaultKind::OldFormat => (
            "ValueError",
            "`weights` belongs to an old format that is no longer read",
        ),
        FaultKind::OpenRange => ("UnboundLocalError", "a range begins with `-`"),
        FaultKind::MissingValue | FaultKind::DroppedRow | FaultKind::NumbersInHeader => {
            return None;
        }
    };
    Some((exception, reason.to_owned()))
}
