//! How large the body of a mesh is, and whether a body can be so large.

use crate::formats::obj::{Mesh, joined};

/// Decimetres. A tenth of an adult is 17 cm, ten times a small figure 10 m; the smallest known base has 32 cm.
pub(crate) const SMALLEST: f32 = 2.0;
/// The same at the other end.
pub(crate) const LARGEST: f32 = 60.0;

/// The largest extent of the shown groups along an axis.
pub(crate) fn extent(mesh: &Mesh, shows: impl Fn(&str) -> bool) -> Option<f32> {
    let groups = mesh.groups.iter().zip(&mesh.facts.bounds);
    let all = groups.filter(|(group, _)| shows(&group.name)).filter_map(|(_, bounds)| *bounds);
    let bounds = all.reduce(|one, other| joined(&one, &other))?;
    Some(bounds.iter().fold(0.0, |most: f32, (lowest, highest)| most.max(highest - lowest)))
}

/// Whether a body can have this extent.
pub(crate) fn is_plausible(extent: f32) -> bool {
    extent > SMALLEST && extent < LARGEST
}
