//! Assets on a figure: read, fitted, and as JSON.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value};

use super::rig::stops;
use crate::files::{read_text, shown};
use crate::outputs::{mesh_json, object, vector};
use crate::{Error, Evaluation};
use mhlint_eval::mpfb::fit::{Row, ScaleLine, Stop, fitted, hidden, scales};
use mhlint_eval::vector::{Point, Vec3};
use mhlint_formats::mhclo::mpfb::in_order::{self, InOrder};
use mhlint_formats::obj::{self, Mesh};

/// An asset with its mesh as Blender imports it.
#[derive(Debug, Clone)]
pub struct Asset {
    /// Its path.
    pub path: String,
    /// Path of its OBJ.
    pub obj_path: PathBuf,
    rows: Vec<Row>,
    read: InOrder,
    /// Vertices of the OBJ that a face uses; all of them where there is no face.
    drawn: Vec<Point>,
    /// Numbers of these vertices in the OBJ.
    used: Vec<usize>,
}

/// An asset on a mesh.
#[derive(Debug, Clone)]
pub struct FittedAsset {
    /// Positions of its vertices, in the units of the mesh.
    pub positions: Vec<Point>,
    /// What offsets were multiplied by along the axes of Blender.
    pub scales: Vec3,
    /// Vertices of the body that it hides.
    pub hidden: Vec<usize>,
}

/// Reads an asset and its OBJ.
///
/// # Errors
/// Files that cannot be read, and lines that stop MPFB.
pub fn read_asset(path: &Path) -> Result<Asset, Error> {
    let read = in_order::read(&read_text(path)?);
    let name = read.obj_file.clone();
    let name =
        name.ok_or_else(|| stops("ValueError", format!("`{}` has no `obj_file`", shown(path))))?;
    let obj_path = path.parent().unwrap_or(Path::new("")).join(name);
    let mesh = obj::parse(&read_text(&obj_path)?);
    Asset::of(shown(path), obj_path, read, &mesh)
}

impl Asset {
    /// An asset out of texts.
    ///
    /// # Errors
    /// Lines that stop MPFB.
    pub(super) fn of(
        path: String,
        obj_path: PathBuf,
        read: InOrder,
        mesh: &Mesh,
    ) -> Result<Self, Error> {
        if let Some((line, exception)) = read.stop {
            return Err(stops(
                exception,
                format!("`{path}`, line {line}: MPFB cannot read it"),
            ));
        }
        let used = used_vertices(mesh);
        let drawn = used
            .iter()
            .filter_map(|at| mesh.positions.get(*at))
            .copied()
            .collect::<Vec<Point>>();
        if read.rows.len() < drawn.len() {
            let reason = format!(
                "`{path}` has {} vertex lines, but its mesh has {} vertices",
                read.rows.len(),
                drawn.len()
            );
            return Err(stops("KeyError", reason));
        }
        if read.are_ranges_first && !drawn.is_empty() {
            let reason = format!(
                "`{path}` has ranges of `delete_verts` above `verts`, which are counted as vertex \
                    lines"
            );
            return Err(stops("KeyError", reason));
        }
        let row = |(vertices, weights, offset): &([i64; 3], [f64; 3], [f64; 3])| Row {
            vertices: *vertices,
            weights: *weights,
            offset: *offset,
        };
        let rows = read.rows.iter().take(drawn.len()).map(row).collect();
        Ok(Self {
            path,
            obj_path,
            rows,
            read,
            drawn,
            used,
        })
    }

    /// Its rows, one a vertex that is drawn.
    pub(super) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The asset on a mesh in Blender's axes, of the figure whose faces are those of `body`.
    ///
    /// # Errors
    /// What stops MPFB.
    pub fn fit(
        &self,
        mesh: &[Point],
        body: &Evaluation,
        scale_factor: f64,
    ) -> Result<FittedAsset, Error> {
        let line = |line: &Option<([i64; 2], f64)>| {
            line.map(|(vertices, distance)| ScaleLine { vertices, distance })
        };
        let [x, y, z] = &self.read.scales;
        let stopped = |stop| {
            let (exception, reason) = match stop {
                Stop::ScaleMissing => ("TypeError", "`x_scale` needs `y_scale` and `z_scale`"),
                Stop::NoDistance => ("ZeroDivisionError", "a scale has the distance 0"),
                Stop::ScaleVertex => ("ValueError", "a scale names a vertex that does not exist"),
                Stop::RowVertex => (
                    "IndexError",
                    "a vertex line names a vertex that does not exist",
                ),
            };
            stops(exception, format!("`{}`: {reason}", self.path))
        };
        let scales = scales(mesh, [line(x), line(y), line(z)], scale_factor).map_err(stopped)?;
        let positions = fitted(mesh, &self.rows, scales, &self.drawn).map_err(stopped)?;
        let scene = body.scene();
        let faces = scene.face_starts.windows(2).filter_map(|ends| match ends {
            [from, to] => scene.corners.get(*from as usize..*to as usize),
            _ => None,
        });
        Ok(FittedAsset {
            positions,
            scales,
            hidden: hidden(&self.read.deleted, mesh.len(), faces),
        })
    }

    /// Positions for all vertices of the OBJ, in its axes as `to_obj` has them: those that Blender
    /// leaves out stay where they are drawn.
    ///
    /// # Errors
    /// An OBJ that cannot be read any more.
    pub fn on_obj(
        &self,
        fitted: &FittedAsset,
        to_obj: impl Fn(Point) -> Point,
    ) -> Result<Vec<Point>, Error> {
        let mut positions = obj::parse(&read_text(&self.obj_path)?).positions;
        for (at, place) in self.used.iter().zip(&fitted.positions) {
            if let Some(slot) = positions.get_mut(*at) {
                *slot = to_obj(*place);
            }
        }
        Ok(positions)
    }

    /// As `mhlint eval fit` shows it.
    ///
    /// # Errors
    /// A chosen vertex that the asset does not have.
    pub fn outputs(
        &self,
        fitted: &FittedAsset,
        vertices: &[i64],
    ) -> Result<Map<String, Value>, Error> {
        let mut outputs = mesh_json(&fitted.positions, vertices)?;
        let distinct: BTreeSet<i64> = self.read.deleted.iter().copied().collect();
        outputs.extend(object([
            ("scale", vector(fitted.scales)),
            ("vertex_count", Value::from(fitted.positions.len())),
            ("ref_count", Value::from(self.read.rows.len())),
            ("delete_lines", Value::from(self.read.deleted.len())),
            ("delete_distinct", Value::from(distinct.len())),
            ("delete_verts", Value::from(fitted.hidden.len())),
            (
                "delete_sum",
                Value::from(fitted.hidden.iter().sum::<usize>()),
            ),
        ]));
        Ok(outputs)
    }
}

/// Blender drops vertices that no face uses, unless there is no face at all.
fn used_vertices(mesh: &Mesh) -> Vec<usize> {
    if mesh.faces.is_empty() {
        return (0..mesh.positions.len()).collect();
    }
    let mut is_used = vec![false; mesh.positions.len()];
    for corner in mesh.faces.iter().flat_map(|face| face.of(&mesh.corners)) {
        if let Some(slot) = is_used.get_mut(*corner as usize) {
            *slot = true;
        }
    }
    is_used
        .iter()
        .enumerate()
        .filter(|(_, is_used)| **is_used)
        .map(|(at, _)| at)
        .collect()
}
