//! What happens to a base mesh over its slider space: the worst that was seen of everything that can go wrong with
//! the shape.
//!
//! Of equally bad settings the first of the plan is kept, whatever the order in which they were looked at, so that the
//! outcome depends neither on threads nor on the order that costs least.

use std::collections::BTreeSet;

/// A face whose area falls to this part of what it is on the default character, or below, has collapsed. The faces of
/// hm08 keep more than that at every setting; two of its smallest babies' faces come below a thousandth.
pub const COLLAPSE_RATIO: f32 = 1e-4;
/// Faces that look the other way count only together: lips, eyelids and sagging breasts of hm08 flip at extremes, up
/// to 64 faces, and 2.6 % of the area. A part of the visible area of the default character.
pub const FLIPPED_SHARE: f64 = 0.05;
/// A vertex farther outside the box of the default character than this many of its diagonals has exploded: the tallest
/// character of hm08 stays within 0.41.
pub const EXPLOSION_DIAGONALS: f32 = 0.6;
/// A bone shorter than this has collapsed, in mesh units (a hundredth of a millimetre).
pub const SHORTEST_BONE: f64 = 1e-4;
/// A joint has left its limb when it moved away from the skin around it by more than this many times its stand on the
/// default character: distance from the mean of that skin, plus the radius of that skin. The joints of hm08 come to 2.2
/// (toes and spine at the corners of age and weight).
pub const DRIFT_STANDS: f64 = 3.0;

/// The worst that was seen of one thing, and at which setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// How bad; larger is worse.
    pub value: f64,
    /// Vertex, face, joint or bone, by number.
    pub element: usize,
    /// How many elements are concerned at this setting.
    pub count: usize,
    /// Number of the setting.
    pub setting: usize,
}

/// Everything that a survey found at fault at some setting, by number.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Concerned {
    /// Vertices that are not finite.
    pub non_finite: BTreeSet<usize>,
    /// Visible faces without area.
    pub collapsed: BTreeSet<usize>,
    /// Visible faces that look the other way where these are too many.
    pub flipped: BTreeSet<usize>,
    /// Vertices far outside the box.
    pub exploded: BTreeSet<usize>,
    /// Joints away from their skin.
    pub drifted: BTreeSet<usize>,
    /// Bones without length.
    pub short_bone: BTreeSet<usize>,
    /// Bones whose planes have no normal.
    pub flat_plane: BTreeSet<usize>,
}

/// What a survey found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Survey {
    /// Vertices that are not finite though no row is; the value is their number.
    pub non_finite: Option<Worst>,
    /// Visible faces without area; the value is their number.
    pub collapsed: Option<Worst>,
    /// Visible faces that look the other way; the value is their part of the visible area.
    pub flipped: Option<Worst>,
    /// Vertex farthest outside the box, in diagonals.
    pub exploded: Option<Worst>,
    /// Joint farthest from its place in the skin, in stands.
    pub drifted: Option<Worst>,
    /// Shortest bone; the value is 1 / length.
    pub short_bone: Option<Worst>,
    /// Plane whose three joints are in line; the value is 1 / sine.
    pub flat_plane: Option<Worst>,
    /// Not only the worst of each.
    pub concerned: Concerned,
}

impl Survey {
    /// Adds what was found at other settings.
    pub fn merge(&mut self, other: Self) {
        let pairs = [
            (&mut self.non_finite, other.non_finite),
            (&mut self.collapsed, other.collapsed),
            (&mut self.flipped, other.flipped),
            (&mut self.exploded, other.exploded),
            (&mut self.drifted, other.drifted),
            (&mut self.short_bone, other.short_bone),
            (&mut self.flat_plane, other.flat_plane),
        ];
        for (slot, found) in pairs {
            found.into_iter().for_each(|found| keep(slot, found));
        }
        self.concerned.merge(other.concerned);
    }
}

impl Concerned {
    fn merge(&mut self, other: Self) {
        self.non_finite.extend(other.non_finite);
        self.collapsed.extend(other.collapsed);
        self.flipped.extend(other.flipped);
        self.exploded.extend(other.exploded);
        self.drifted.extend(other.drifted);
        self.short_bone.extend(other.short_bone);
        self.flat_plane.extend(other.flat_plane);
    }
}

/// Keeps the worse; of equals that of the earlier setting, and at one setting the one seen first.
pub(super) fn keep(slot: &mut Option<Worst>, found: Worst) {
    let is_worse =
        |known: &Worst| found.value > known.value || (found.value >= known.value && found.setting < known.setting);
    if slot.as_ref().is_none_or(is_worse) {
        *slot = Some(found);
    }
}
