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

/// What was seen of one thing that can go wrong.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Fault {
    /// The worst; none where nothing was seen.
    pub worst: Option<Worst>,
    /// All vertices, faces, joints or bones at fault at some setting, by number.
    pub elements: BTreeSet<usize>,
}

/// What a survey found.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Survey {
    /// Vertices that are not finite though no row is; the value is their number.
    pub non_finite: Fault,
    /// Visible faces without area; the value is their number.
    pub collapsed: Fault,
    /// Visible faces that look the other way where these are too many; the value is their part of the visible area.
    pub flipped: Fault,
    /// Vertices far outside the box; the value is in diagonals.
    pub exploded: Fault,
    /// Joints away from their place in the skin; the value is in stands.
    pub drifted: Fault,
    /// Bones without length; the value is 1 / length.
    pub short_bone: Fault,
    /// Bones whose planes have no normal; the value is 1 / sine.
    pub flat_plane: Fault,
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
        for (fault, Fault { worst, elements }) in pairs {
            if let Some(worst) = worst {
                fault.add(worst, elements);
            }
        }
    }
}

impl Fault {
    /// Adds elements. Keeps the worse; of equals that of the earlier setting, and at one setting the one seen first.
    pub(super) fn add(&mut self, found: Worst, elements: impl IntoIterator<Item = usize>) {
        let is_worse =
            |known: &Worst| found.value > known.value || (found.value >= known.value && found.setting < known.setting);
        if self.worst.as_ref().is_none_or(is_worse) {
            self.worst = Some(found);
        }
        self.elements.extend(elements);
    }
}
