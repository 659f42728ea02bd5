//! Left and right bones of rigs, by their names.

use crate::eval::side::{self, Side};

/// The side that the name of a bone says, and the name of its partner: also `mixamorig:LeftHand`, `LThumb`.
pub(super) fn of(name: &str) -> Option<(Side, String)> {
    side::of_bone(name).or_else(|| behind_colon(name)).or_else(|| by_capital(name))
}

fn behind_colon(name: &str) -> Option<(Side, String)> {
    let (prefix, own) = name.split_once(':')?;
    let (side, partner) = side::of_bone(own)?;
    Some((side, format!("{prefix}:{partner}")))
}

/// `LThumb`, `RThumb`: a capital for the side before another one.
fn by_capital(name: &str) -> Option<(Side, String)> {
    let rest = name.get(1..).filter(|rest| rest.starts_with(|next: char| next.is_ascii_uppercase()))?;
    match name.as_bytes().first()? {
        b'L' => Some((Side::Left, format!("R{rest}"))),
        b'R' => Some((Side::Right, format!("L{rest}"))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn partners_are_found_by_name() {
        let partner = |name: &str| of(name).map(|(_, partner)| partner);
        for (left, right) in [("hand.L", "hand.R"), ("hand_l", "hand_r"), ("mixamorig:LeftHand", "mixamorig:RightHand"), ("LToe", "RToe")] {
            assert_eq!(partner(left).as_deref(), Some(right));
            assert_eq!(partner(right).as_deref(), Some(left));
        }
        for centre in ["Root", "LowerBack", "spine", "", "L", "é"] {
            assert_eq!(partner(centre), None, "{centre}");
        }
    }
}
