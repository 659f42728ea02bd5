//! Assets of the `.mhclo` kind, fitted to a base mesh
//! (`docs/loaders/makehuman2/clothes.md#fitting`).

use std::path::{Path, PathBuf};

use super::weights::number;
use super::{stopped, stops};
use crate::Error;
use crate::Evaluation;
use crate::asset_file::{AssetFile, read};
use crate::data::{Fitted, NamedWeights};
use mhlint_diag::Application;
use mhlint_eval::fit::{Reference, ScaleLine, deleted_vertices, fit};
use mhlint_eval::influences::Influences;
use mhlint_eval::makehuman2::fit::{axis_scales, derived_weights};
use mhlint_eval::vector::Point;
use mhlint_formats::mhclo::Clothes;
use mhlint_formats::mhclo::makehuman2::READER;

/// An asset with its mesh.
#[derive(Debug, Clone)]
pub struct Asset {
    /// Its path.
    pub path: String,
    /// What is in it.
    pub clothes: Clothes,
    /// Path of its OBJ.
    pub obj_path: PathBuf,
    /// Positions in the OBJ.
    pub positions: Vec<Point>,
    references: Vec<Reference>,
    lines: [Option<ScaleLine>; 3],
}

/// Reads an asset and its OBJ.
///
/// # Errors
/// Files that cannot be read, and lines that stop the application.
pub fn read_asset(path: &Path) -> Result<Asset, Error> {
    let AssetFile {
        path,
        clothes,
        obj_path,
        positions,
    } = read(path, Application::Makehuman2, &READER)?;
    let mut asset = Asset {
        path,
        clothes,
        obj_path,
        positions,
        references: Vec::new(),
        lines: [None; 3],
    };
    asset.resolve()?;
    Ok(asset)
}

impl Asset {
    fn resolve(&mut self) -> Result<(), Error> {
        let rows = self.clothes.references.len();
        if rows == 0 || rows > self.positions.len() {
            let reason = format!(
                "`{}` has {rows} vertex lines, but its mesh has {} vertices",
                self.path,
                self.positions.len()
            );
            return Err(stops("IndexError", reason));
        }
        for line in &self.clothes.references {
            let vertices = line.vertices.map(|vertex| self.vertex(vertex, line.line));
            let [a, b, c] = vertices;
            let vertices = [a?, b?, c?];
            self.references.push(Reference {
                vertices,
                weights: line.weights,
                offset: line.offset,
            });
        }
        for axis in 0..3 {
            let Some(line) = self.clothes.scales.get(axis).copied().flatten() else {
                continue;
            };
            let [a, b] = line.vertices.map(|vertex| self.vertex(vertex, line.line));
            self.lines[axis] = Some(ScaleLine {
                vertices: [a?, b?],
                distance: line.distance,
            });
        }
        Ok(())
    }

    fn vertex(&self, vertex: i64, line: u32) -> Result<u32, Error> {
        let outside = |_| {
            stops(
                "OverflowError",
                format!(
                    "`{}`, line {line}: vertex {vertex} does not exist",
                    self.path
                ),
            )
        };
        u32::try_from(vertex).map_err(outside)
    }

    /// Whether it replaces the body and is therefore never scaled.
    pub fn is_proxy(&self) -> bool {
        Path::new(&self.path)
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("proxy"))
    }

    /// The asset on the mesh `positions`, with scales measured on the mesh `measured`.
    ///
    /// # Errors
    /// References outside the mesh.
    pub fn fit(
        &self,
        positions: &[Point],
        measured: &[Point],
        is_proxy: bool,
    ) -> Result<Fitted, Error> {
        let lines = if is_proxy { [None; 3] } else { self.lines };
        let scales = axis_scales(measured, lines).map_err(stopped)?;
        let mut fitted = fit(positions, &self.references, scales).map_err(stopped)?;
        fitted.extend_from_slice(self.positions.get(fitted.len()..).unwrap_or_default());
        let deleted = deleted_vertices(&self.clothes.deleted, positions.len()).map_err(stopped)?;
        let deleted = deleted.into_iter().filter(|deleted| *deleted).count();
        Ok(Fitted {
            positions: fitted,
            references: self.references.len(),
            scales,
            deleted,
        })
    }

    /// Weights taken from the body, for an asset without weights of its own.
    ///
    /// # Errors
    /// The base has no usable weights.
    pub fn derived_weights(&self, body: &Evaluation, root: &str) -> Result<NamedWeights, Error> {
        let skeleton = body
            .scene
            .skeleton
            .as_ref()
            .zip(body.scene.weights.as_ref());
        let (skeleton, weights) = skeleton.ok_or_else(|| Error::NoSkeleton {
            base: body.base.clone(),
            reason: "it has no usable skeleton with weights".to_owned(),
        })?;
        let mut names = skeleton.names.clone();
        let root = number(&mut names, root);
        let influences =
            Influences::new(&weights.bones, body.scene.positions.len()).map_err(stopped)?;
        let loaded = derived_weights(&self.references, &influences, root).map_err(stopped)?;
        Ok(NamedWeights { names, loaded })
    }
}
