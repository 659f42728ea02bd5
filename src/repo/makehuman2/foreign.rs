//! A base mesh that the rest of the data is not made for: exported anew with vertices more or less, or packed from
//! another one.

use super::{Base, UnreadMesh};
use crate::formats::mhw::Weights;
use crate::formats::obj::Mesh;

/// Whether `base.json` and the weights for poses, which know each vertex, agree on another number of vertices than the mesh
/// has. Where they disagree between themselves nobody can tell which of them is wrong. Beside an archive without such
/// weights it is the OBJ that knows.
pub(super) fn is_foreign(mesh: &Mesh, base: &Base<'_>) -> bool {
    let claimed = base.settings().and_then(|(_, settings)| usize::try_from(settings.numverts?).ok());
    let weights = base.pose_rig().and_then(|(rig, _)| rig.weights());
    let mut texts = base.mesh_files.unread.iter().filter_map(UnreadMesh::sound);
    let Some(claimed) = claimed.filter(|claimed| *claimed != mesh.facts.vertices) else { return false };
    weights
        .and_then(vertices_of)
        .map_or_else(|| texts.any(|text| text.facts.vertices == claimed), |made_for| made_for == claimed)
}

/// How many vertices weights are made for, if they name the last one.
fn vertices_of(weights: &Weights) -> Option<usize> {
    let vertices = weights.bones.iter().flat_map(|bone| &bone.pairs).map(|pair| pair.vertex);
    vertices.max().and_then(|last| usize::try_from(last).ok()).map(|last| last.saturating_add(1))
}
