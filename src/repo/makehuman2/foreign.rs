//! A base mesh that the rest of the data is not made for: exported anew with vertices more or less.

use super::Base;
use crate::formats::mhw::Weights;
use crate::formats::obj::Mesh;

/// Whether `base.json` and the weights for poses, which know each vertex, agree on another number of vertices than the mesh
/// has. Where they disagree between themselves nobody can tell which of them is wrong.
pub(super) fn is_foreign(mesh: &Mesh, base: &Base<'_>) -> bool {
    let claimed = base.settings().and_then(|(_, settings)| usize::try_from(settings.numverts?).ok());
    let weights = base.pose_rig().and_then(|(rig, _)| rig.weights());
    claimed.is_some_and(|claimed| claimed != mesh.facts.vertices && weights.and_then(vertices_of) == Some(claimed))
}

/// How many vertices weights are made for, if they name the last one.
fn vertices_of(weights: &Weights) -> Option<usize> {
    let vertices = weights.bones.iter().flat_map(|bone| &bone.pairs).map(|pair| pair.vertex);
    vertices.max().and_then(|last| usize::try_from(last).ok()).map(|last| last.saturating_add(1))
}
