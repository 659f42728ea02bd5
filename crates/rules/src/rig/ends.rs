//! Ends of bones: which there are, and what becomes of one whose place is not found.

use mhlint_diag::{Application::Mpfb, Case, Level};
use mhlint_formats::rig::{DefaultPosition, End, Rig, RigBone};

/// What an end comes to that stays at its default position.
pub(super) const AT_DEFAULT: Case = &[(
    Mpfb,
    Level::Warning,
    "silently puts the end at `default_position`: it follows no morph",
)];

/// All ends of a rig that could be read, each with its key.
pub(super) fn ends(rig: &Rig) -> impl Iterator<Item = (&RigBone, &'static str, &End)> {
    rig.bones.iter().flat_map(|bone| {
        let ends = [("head", bone.head.as_ref()), ("tail", bone.tail.as_ref())];
        ends.into_iter()
            .filter_map(move |(key, end)| Some((bone, key, end?)))
    })
}

/// Whether there is a place for an end that its strategy does not find.
pub(super) const fn has_place(end: &End) -> bool {
    matches!(end.default_position, DefaultPosition::At(_))
}
