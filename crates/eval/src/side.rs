//! Sides in names, as authors and exporters write them.

/// One side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// That of positive x.
    Left,
    /// That of negative x.
    Right,
}

/// Nearer to the middle plane than this nothing lies on a side, mesh units.
const MIDDLE: f32 = 0.1;

impl Side {
    /// The side of the middle plane x = 0 on which something lies; `None` near it.
    pub fn at(x: f32) -> Option<Self> {
        match x {
            x if x > MIDDLE => Some(Self::Left),
            x if x < -MIDDLE => Some(Self::Right),
            _ => None,
        }
    }

    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// Endings of the names of left and right bones.
const ENDINGS: [(&str, &str); 5] = [
    (".L", ".R"),
    ("_L", "_R"),
    ("_l", "_r"),
    ("-l", "-r"),
    (".l", ".r"),
];
/// Beginnings of them.
const BEGINNINGS: [(&str, &str); 4] = [
    ("l-", "r-"),
    ("l_", "r_"),
    ("Left", "Right"),
    ("left", "right"),
];
/// Words in the names of targets.
const WORDS: [(&str, &str); 2] = [("l", "r"), ("left", "right")];

/// The side that the name of a bone says, and the name of its partner (`upperarm.L`, `l-thigh`,
/// `LeftFoot`).
pub fn of_bone(name: &str) -> Option<(Side, String)> {
    let ending = |own: &str, other: &str| Some(format!("{}{other}", name.strip_suffix(own)?));
    let beginning = |own: &str, other: &str| Some(format!("{other}{}", name.strip_prefix(own)?));
    either(&ENDINGS, ending).or_else(|| either(&BEGINNINGS, beginning))
}

/// The side that the name of a target says as a word between dashes, and the name of its partner
/// (`l-ear-up`).
pub fn of_target(stem: &str) -> Option<(Side, String)> {
    let mut words: Vec<&str> = stem.split('-').collect();
    let (at, side, other) = words.iter().enumerate().find_map(|(at, word)| {
        let (side, other) = either(&WORDS, |own, other| {
            (*word == own).then(|| other.to_owned())
        })?;
        Some((at, side, other))
    })?;
    *words.get_mut(at)? = &other;
    Some((side, words.join("-")))
}

/// Whether a word says a side.
pub fn is_word(word: &str) -> bool {
    WORDS
        .iter()
        .any(|(left, right)| word == *left || word == *right)
}

fn either(
    pairs: &[(&str, &str)],
    other: impl Fn(&str, &str) -> Option<String>,
) -> Option<(Side, String)> {
    pairs.iter().find_map(|(left, right)| {
        let of_left = other(left, right).map(|other| (Side::Left, other));
        of_left.or_else(|| Some((Side::Right, other(right, left)?)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bone_has_its_side_at_an_end_of_its_name() {
        for (name, side, partner) in [
            ("upperarm.L", Side::Left, "upperarm.R"),
            ("calf_r", Side::Right, "calf_l"),
            ("l-thigh", Side::Left, "r-thigh"),
            ("RightFoot", Side::Right, "LeftFoot"),
        ] {
            assert_eq!(of_bone(name), Some((side, partner.to_owned())), "{name}");
        }
        assert_eq!((of_bone("root"), of_bone("Lower")), (None, None));
    }

    #[test]
    fn a_target_has_its_side_as_a_word() {
        for (stem, found) in [
            ("l-ear-trans-in", Some((Side::Left, "r-ear-trans-in"))),
            ("ear-r-up", Some((Side::Right, "ear-l-up"))),
            ("left-arm", Some((Side::Left, "right-arm"))),
            ("chin-cleft-decr", None),
            ("lip", None),
        ] {
            assert_eq!(
                of_target(stem),
                found.map(|(side, other)| (side, other.to_owned())),
                "{stem}"
            );
        }
        assert!(is_word("right") && !is_word("lip"));
    }
}
