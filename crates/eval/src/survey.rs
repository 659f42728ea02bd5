//! What happens to a base mesh over its slider space: the worst that was seen of everything that
//! can go wrong with the shape.
//!
//! Of equally bad settings the first of the plan is kept, whatever the order in which they were
//! looked at, so that the outcome depends neither on threads nor on the order that costs least.

use std::collections::{BTreeMap, BTreeSet};

/// A face whose area falls to this part of what it is on the default character, or below, has
/// collapsed. The faces of hm08 keep more than that at every setting; two of its smallest babies'
/// faces come below a thousandth.
pub const COLLAPSE_RATIO: f32 = 1e-4;
/// Faces that look the other way count only together: lips, eyelids and sagging breasts of hm08
/// flip at extremes, up to 64 faces, and 2.6 % of the area. A part of the visible area of the
/// default character.
pub const FLIPPED_SHARE: f64 = 0.05;
/// A vertex farther outside the box of the default character than this many of its diagonals has
/// exploded: the tallest character of hm08 stays within 0.41.
pub const EXPLOSION_DIAGONALS: f32 = 0.6;
/// A bone shorter than this has collapsed, in mesh units (a hundredth of a millimetre).
pub const SHORTEST_BONE: f64 = 1e-4;
/// A joint has left its limb when it moved away from the skin around it by more than this many
/// times its stand on the default character: distance from the mean of that skin, plus the radius
/// of that skin. The joints of hm08 come to 2.2 (toes and spine at the corners of age and weight).
pub const DRIFT_STANDS: f64 = 3.0;

/// The same for a vertex of something worn.
pub const DETACHED_STANDS: f64 = 3.0;
/// And it has moved by this many diagonals of the box of the default character (6 cm on hm08):
/// clothes of MakeHuman under a breast at its largest come to 4.5 cm.
pub const DETACHED_DIAGONALS: f32 = 0.03;

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

/// What can go wrong with the shape, the gravest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Trouble {
    /// Vertices that are not finite though no row is; the value is their number.
    NonFinite,
    /// Vertices far outside the box; the value is in diagonals of it.
    Exploded,
    /// Bones without length; the value is 1 / length.
    ShortBone,
    /// Bones whose planes have no normal; the value is 1 / sine.
    FlatPlane,
    /// Visible faces without area; the value is their number.
    Collapsed,
    /// Visible faces that look the other way where these are too many; the value is their part of
    /// the visible area.
    Flipped,
    /// Joints away from their place in the skin; the value is in stands (distance plus radius of
    /// that skin at rest).
    Drifted,
    /// Vertices of the asset with this number away from the skin that they lie on; the value is in
    /// stands.
    Detached(u32),
}

/// What a survey found.
pub type Survey = BTreeMap<Trouble, Fault>;

/// Adds elements. Keeps the worse; of equals that of the earlier setting, and at one setting the
/// one seen first.
pub(super) fn add(
    survey: &mut Survey,
    trouble: Trouble,
    found: Worst,
    elements: impl IntoIterator<Item = usize>,
) {
    let fault = survey.entry(trouble).or_default();
    let is_worse = |known: &Worst| {
        found.value > known.value || (found.value >= known.value && found.setting < known.setting)
    };
    if fault.worst.as_ref().is_none_or(is_worse) {
        fault.worst = Some(found);
    }
    fault.elements.extend(elements);
}

/// Adds what was found at other settings.
pub fn merge(survey: &mut Survey, other: Survey) {
    for (trouble, Fault { worst, elements }) in other {
        worst
            .into_iter()
            .for_each(|worst| add(survey, trouble, worst, elements.iter().copied()));
    }
}
