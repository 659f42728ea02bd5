//! Ends of bones: all of a rig, and what happens to an end whose place is not found.

use mhlint_diag::{Application::Mpfb, Case, Level};
use mhlint_formats::rig::{DefaultPosition, End, Rig, RigBone, Strategy};

/// What happens if an end stays at its default position.
pub(super) const AT_DEFAULT: Case = &[(
    Mpfb,
    Level::Warning,
    "silently puts the end at `default_position`: it follows no morph",
)];

/// All ends in a rig that can be read, each with its bone and its key.
pub(super) fn ends(rig: &Rig) -> impl Iterator<Item = (&RigBone, &'static str, &End)> {
    rig.bones.iter().flat_map(|bone| {
        let ends = [("head", bone.head.as_ref()), ("tail", bone.tail.as_ref())];
        ends.into_iter()
            .filter_map(move |(key, end)| Some((bone, key, end?)))
    })
}

/// Whether an end has a default position to fall back on if its strategy finds no place.
pub(super) const fn has_place(end: &End) -> bool {
    matches!(end.default_position, DefaultPosition::At(_))
}

/// The vertices that the strategy of an end names.
pub(super) fn listed(end: &End) -> impl Iterator<Item = i64> {
    let (one, many) = match &end.strategy {
        Strategy::Vertex(vertex) => (Some(*vertex), [].as_slice()),
        Strategy::Mean(vertices) | Strategy::Xyz(vertices) => (None, vertices.as_slice()),
        _ => (None, [].as_slice()),
    };
    one.into_iter().chain(many.iter().copied())
}

/// Whether an end names a negative vertex: it lies elsewhere for that reason, which is a finding of
/// its own (`rig-vertex-out-of-range`).
pub(super) fn is_negative(end: &End) -> bool {
    listed(end).any(|vertex| vertex < 0)
}
