//! Assets as MakeHuman 1 fits them (`docs/loaders/makehuman1/clothes.md#fitting`).

use std::path::{Path, PathBuf};

use super::worn::stretch;
use crate::Error;
use crate::asset_file::{AssetFile, read};
use crate::data::Fitted;
use crate::worn::references;
use mhlint_diag::Application;
use mhlint_eval::fit::{Reference, deleted_vertices, fit};
use mhlint_eval::makehuman1::fit::Stretch;
use mhlint_eval::vector::Point;
use mhlint_formats::mhclo::makehuman1::READER;

const OWN: Application = Application::Makehuman1;

/// An asset with its mesh.
#[derive(Debug, Clone)]
pub struct Asset {
    /// Its path.
    pub path: String,
    /// Path of its OBJ.
    pub obj_path: PathBuf,
    /// Runs of base vertices that it hides, both ends included.
    deleted: Vec<(i64, i64)>,
    references: Vec<Reference>,
    stretch: Stretch,
}

/// Reads an asset and its OBJ.
///
/// # Errors
/// Files that cannot be read, and lines that stop the application; rows that are not as many as
/// vertices.
pub fn read_asset(path: &Path) -> Result<Asset, Error> {
    let AssetFile {
        path,
        clothes,
        obj_path,
        positions,
    } = read(path, OWN, &READER)?;
    let stops = |exception, reason| Error::Stops {
        application: OWN,
        exception,
        reason,
    };
    let clothes = clothes.kept();
    let rows = clothes.rows.count;
    if clothes.kept.len() != rows {
        let reason = format!("`{path}`: a vertex row names a vertex that does not exist");
        return Err(stops("OverflowError", reason));
    }
    let mut references = references(&clothes.kept);
    match references.as_slice() {
        [] => return Err(stops("IndexError", format!("`{path}` has no vertex lines"))),
        // NumPy repeats a single row for all vertices.
        [only] => references = vec![*only; positions.len()],
        rows if rows.len() == positions.len() => {}
        rows => {
            let counts = format!(
                "{} vertex lines, but its mesh has {} vertices",
                rows.len(),
                positions.len()
            );
            return Err(stops("ValueError", format!("`{path}` has {counts}")));
        }
    }
    let stretch = stretch(&clothes);
    Ok(Asset {
        path,
        obj_path,
        deleted: clothes.deleted,
        references,
        stretch,
    })
}

impl Asset {
    /// The asset on the mesh `positions`, with scales measured on the same.
    ///
    /// # Errors
    /// References outside the mesh, a scale without one of its axes.
    pub fn fit(&self, positions: &[Point]) -> Result<Fitted, Error> {
        let index = |error| Error::index(OWN, error);
        let scales = self.stretch.factors(positions).map_err(index)?;
        let fitted = fit(positions, &self.references, scales).map_err(index)?;
        let deleted = deleted_vertices(&self.deleted, positions.len()).map_err(index)?;
        let deleted = deleted.into_iter().filter(|deleted| *deleted).count();
        Ok(Fitted {
            positions: fitted,
            references: self.references.len(),
            scales,
            deleted,
        })
    }
}
