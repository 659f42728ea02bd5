//! How large the body of a mesh is, and whether a body can be so large.

use super::{Body, Rig};
use mhlint_formats::obj::{Mesh, joined};

/// Decimetres. A tenth of an adult is 17 cm, ten times a small figure 10 m; the smallest known base
/// has 32 cm.
pub const SMALLEST: f32 = 2.0;
/// The same at the other end.
pub const LARGEST: f32 = 60.0;

/// The largest extent of the shown groups along an axis.
fn extent(mesh: &Mesh, shows: impl Fn(&str) -> bool) -> Option<f32> {
    let groups = mesh.groups.iter().zip(&mesh.facts.bounds);
    let all = groups
        .filter(|(group, _)| shows(&group.name))
        .filter_map(|(_, bounds)| *bounds);
    let bounds = all.reduce(|one, other| joined(&one, &other))?;
    Some(bounds.iter().fold(0.0, |most: f32, (lowest, highest)| {
        most.max(highest - lowest)
    }))
}

/// The extent of what is shown of a body, where no body can have it. A mesh without a skeleton need
/// not be one.
pub fn implausible(body: &Body<'_>) -> Option<f32> {
    let (_, mesh) = body
        .mesh
        .filter(|(_, mesh)| mesh.facts.non_finite.count == 0)?;
    let skeleton = body.default_rig().and_then(Rig::skeleton);
    skeleton.filter(|skeleton| !skeleton.bones.is_empty())?;
    extent(mesh, |group| body.shows(group)).filter(|extent| !is_plausible(*extent))
}

/// Whether a body can have this extent.
fn is_plausible(extent: f32) -> bool {
    extent > SMALLEST && extent < LARGEST
}
