//! What the body of MPFB wears, as it fits it (`docs/loaders/mpfb/clothes.md#fitting`). Axes and
//! unit are those of the files: what Blender does with them changes no shape.

use std::collections::BTreeMap;

use super::base::SHOWN;
use crate::worn::{Fitted, fitted, measure_all, scale_lines, skin};
use mhlint_eval::fit::ScaleLine;
use mhlint_eval::vector::{Point, Vec3};
use mhlint_eval::worn::WornMeasure;
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::obj::Mesh;
use mhlint_repo::mpfb::View;
use mhlint_repo::{Layers, Worn};

/// The mesh that assets are fitted to, if its vertices can be counted on.
pub(crate) fn mesh<'v>(view: &View<'v>) -> Option<&'v Mesh> {
    view.mesh
        .map(|(_, mesh)| mesh)
        .filter(|mesh| mesh.is_sound())
}

/// The assets of the checked layer that can be fitted.
pub(crate) fn fit<'w>(mesh: &Mesh, worn: &'w [Worn<'w>], layers: Layers<'_>) -> Vec<Fitted<'w>> {
    // Blender drops loose vertices, and rows are counted without them: that is told of the mesh.
    let is_counted = |worn: &&Worn<'_>| worn.mesh().is_none_or(|(_, mesh)| uses_all(mesh));
    let own = worn
        .iter()
        .filter(|worn| layers.is_checked(worn.file))
        .filter(is_counted);
    fitted(mesh, own, |_, clothes| {
        scales(&mesh.positions, scale_lines(clothes)).map(Some)
    })
}

/// Measures them.
pub(crate) fn measure(mesh: &Mesh, fitted: &[Fitted<'_>]) -> BTreeMap<String, WornMeasure> {
    if fitted.is_empty() {
        BTreeMap::new()
    } else {
        measure_all(mesh, &skin(mesh, |group| group == SHOWN), fitted)
    }
}

/// What offsets are multiplied by: 1 without a line for x. `None` where MPFB stops.
fn scales(positions: &[Point], lines: [Option<ScaleLine>; 3]) -> Option<Vec3> {
    let [Some(x), y, z] = lines else {
        return Some([1.0; 3]);
    };
    let along = |line: ScaleLine, axis: usize| {
        let at = |vertex: u32| {
            positions
                .get(vertex as usize)?
                .get(axis)
                .copied()
                .map(f64::from)
        };
        let [from, to] = line.vertices;
        let share = (at(from)? - at(to)?).abs() / f64::from(line.distance);
        share.is_finite().then_some(share)
    };
    Some([along(x, 0)?, along(y?, 1)?, along(z?, 2)?])
}

fn uses_all(mesh: &AssetMesh) -> bool {
    let mut is_used = vec![false; mesh.positions.len()];
    for corner in &mesh.corners {
        if let Some(slot) = is_used.get_mut(*corner as usize) {
            *slot = true;
        }
    }
    is_used.into_iter().all(|is_used| is_used)
}
