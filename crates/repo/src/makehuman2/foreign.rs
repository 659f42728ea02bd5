//! A base mesh that the rest of the data is not made for: exported anew with vertices more or less,
//! or in another order, or packed from another one.

use super::{Base, UnreadMesh};
use crate::FileFacts;
use crate::cubes::{Strays, strays_of};
use mhlint_formats::mhw::Weights;
use mhlint_formats::obj::Mesh;

/// A mesh that nothing can be measured against.
#[derive(Debug, Clone, Copy)]
pub struct ForeignMesh<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The mesh.
    pub mesh: &'a Mesh,
    /// What tells.
    pub sign: ForeignSign,
}

/// What shows that a mesh is foreign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForeignSign {
    /// The number of its vertices.
    Count,
    /// The joints of the skeleton.
    Order(Strays),
}

/// What shows that the mesh of a base is foreign, if anything does.
pub(super) fn sign_of(mesh: &Mesh, base: &Base<'_>) -> Option<ForeignSign> {
    if has_other_count(mesh, base) {
        Some(ForeignSign::Count)
    } else {
        order(mesh, base)
    }
}

/// Whether `base.json` and the weights for poses, which know each vertex, agree on another number
/// of vertices than the mesh has. Where they disagree between themselves nobody can tell which of
/// them is wrong. Beside an archive without such weights it is the OBJ that knows.
fn has_other_count(mesh: &Mesh, base: &Base<'_>) -> bool {
    let claimed = base
        .settings()
        .and_then(|(_, settings)| usize::try_from(settings.numverts?).ok());
    let weights = base.pose_rig().and_then(|(rig, _)| rig.weights());
    let mut texts = base.mesh_files.unread.iter().filter_map(UnreadMesh::sound);
    let Some(claimed) = claimed.filter(|claimed| *claimed != mesh.facts.vertices) else {
        return false;
    };
    weights.and_then(vertices_of).map_or_else(
        || texts.any(|text| text.facts.vertices == claimed),
        |made_for| made_for == claimed,
    )
}

/// How many vertices weights are made for, if they name the last one.
fn vertices_of(weights: &Weights) -> Option<usize> {
    let vertices = weights
        .bones
        .iter()
        .flat_map(|bone| &bone.pairs)
        .map(|pair| pair.vertex);
    vertices
        .max()
        .and_then(|last| usize::try_from(last).ok())
        .map(|last| last.saturating_add(1))
}

/// Whether most joints of the skeleton for poses have none of their vertices in their cube.
fn order(mesh: &Mesh, base: &Base<'_>) -> Option<ForeignSign> {
    let (_, skeleton) = base.pose_rig()?;
    strays_of(mesh, &skeleton.joints).map(ForeignSign::Order)
}
