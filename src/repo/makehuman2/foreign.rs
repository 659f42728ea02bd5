//! A base mesh that the rest of the data is not made for: exported anew with vertices more or less, or in another order,
//! or packed from another one.

use std::collections::BTreeMap;

use super::{Base, UnreadMesh};
use crate::formats::mhskel::Joint;
use crate::formats::mhw::Weights;
use crate::formats::obj::{Group, Mesh};
use crate::repo::FileFacts;

/// A mesh that nothing can be measured against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ForeignMesh<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The mesh.
    pub mesh: &'a Mesh,
    /// What tells.
    pub sign: ForeignSign,
}

/// What shows that a mesh is foreign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ForeignSign {
    /// The number of its vertices.
    Count,
    /// The joints of the skeleton: so many of so many lie in no cube of theirs.
    Order { strayed: usize, of: usize },
}

/// What begins the names of the groups that are cubes of joints.
const CUBE: &str = "joint-";
/// Vertices of a cube.
const CORNERS: usize = 8;
/// Fewer joints show nothing.
const FEWEST_JOINTS: usize = 4;

/// What shows that the mesh of a base is foreign, if anything does.
pub(super) fn sign_of(mesh: &Mesh, base: &Base<'_>) -> Option<ForeignSign> {
    if has_other_count(mesh, base) { Some(ForeignSign::Count) } else { order(mesh, base) }
}

/// Whether `base.json` and the weights for poses, which know each vertex, agree on another number of vertices than the mesh
/// has. Where they disagree between themselves nobody can tell which of them is wrong. Beside an archive without such
/// weights it is the OBJ that knows.
fn has_other_count(mesh: &Mesh, base: &Base<'_>) -> bool {
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

/// Whether most joints of the skeleton for poses have none of their vertices in their cube. A few may be meant so, or are
/// slips of the skeleton.
fn order(mesh: &Mesh, base: &Base<'_>) -> Option<ForeignSign> {
    let (_, skeleton) = base.pose_rig()?;
    let cubes = Cubes::of(mesh);
    let strays: Vec<bool> = skeleton.joints.iter().filter_map(|joint| cubes.has_stray(joint)).collect();
    let (strayed, of) = (strays.iter().filter(|stray| **stray).count(), strays.len());
    (of >= FEWEST_JOINTS && 2 * strayed > of).then_some(ForeignSign::Order { strayed, of })
}

/// The cubes of joints: first and last vertex by name, and all in order, each with the highest last vertex so far.
struct Cubes<'m> {
    by_name: BTreeMap<&'m str, (u32, u32)>,
    in_order: Vec<(u32, u32)>,
}

impl<'m> Cubes<'m> {
    fn of(mesh: &'m Mesh) -> Self {
        // Where faces of one group are put into another one, the vertices of neither say anything.
        let mixed = mesh.facts.mixed_groups();
        let mut by_name = BTreeMap::new();
        for (name, ends) in mesh.groups.iter().filter(|group| !mixed.contains(group.name.as_str())).filter_map(cube) {
            by_name.entry(name).or_insert(ends);
        }
        let mut in_order: Vec<(u32, u32)> = by_name.values().copied().collect();
        in_order.sort_unstable();
        let mut highest = 0;
        for (_, last) in &mut in_order {
            highest = highest.max(*last);
            *last = highest;
        }
        Self { by_name, in_order }
    }

    /// Whether a joint lies in no cube: in that of its name, or where there is none in any. Nothing where it seems not to
    /// be meant for one.
    fn has_stray(&self, joint: &Joint) -> Option<bool> {
        let vertices = joint.vertices.as_deref()?;
        let is_in =
            |first: u32, last: u32| vertices.iter().any(|vertex| (i64::from(first)..=i64::from(last)).contains(vertex));
        match self.by_name.get(joint.name.as_str()) {
            Some((first, last)) => (!vertices.is_empty()).then(|| !is_in(*first, *last)),
            None => (is_run(vertices) && !self.by_name.is_empty()).then(|| !self.meet(vertices)),
        }
    }

    /// Whether vertices in a row meet a cube.
    fn meet(&self, run: &[i64]) -> bool {
        let (Some(from), Some(to)) = (run.first(), run.last()) else { return false };
        let begun = self.in_order.partition_point(|(first, _)| i64::from(*first) <= *to);
        begun.checked_sub(1).and_then(|at| self.in_order.get(at)).is_some_and(|(_, last)| i64::from(*last) >= *from)
    }
}

fn cube(group: &Group) -> Option<(&str, (u32, u32))> {
    Some((group.name.strip_prefix(CUBE)?, group.vertices?))
}

/// Whether these are the vertices of a cube as programs number them; eight around a limb are not in a row.
fn is_run(vertices: &[i64]) -> bool {
    vertices.len() == CORNERS
        && vertices.windows(2).all(|pair| matches!(pair, [one, next] if one.checked_add(1) == Some(*next)))
}
