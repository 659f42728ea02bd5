//! Left and right bones of a rig, by their names; bones on the wrong side, and bones with swapped
//! ends.

use super::located::{Placed, apart, by_name};
use mhlint_diag::{Grouped, grouped};
use mhlint_eval::side::{self, Side};

/// The side in the name of a bone, and the name of the bone on the other side. Also understands
/// names such as `mixamorig:LeftHand` and `LThumb`.
pub(super) fn of(name: &str) -> Option<(Side, String)> {
    side::of_bone(name)
        .or_else(|| behind_colon(name))
        .or_else(|| by_capital(name))
}

fn behind_colon(name: &str) -> Option<(Side, String)> {
    let (prefix, own) = name.split_once(':')?;
    let (side, partner) = side::of_bone(own)?;
    Some((side, format!("{prefix}:{partner}")))
}

/// Names such as `LThumb` and `RThumb`: a capital for the side, and another capital behind it.
fn by_capital(name: &str) -> Option<(Side, String)> {
    let rest = name
        .get(1..)
        .filter(|rest| rest.starts_with(|next: char| next.is_ascii_uppercase()))?;
    match name.as_bytes().first()? {
        b'L' => Some((Side::Left, format!("R{rest}"))),
        b'R' => Some((Side::Right, format!("L{rest}"))),
        _ => None,
    }
}

/// A place that is nearer than this to the middle plane is on neither side, in metres.
const MIDDLE: f64 = 0.01;

/// Whether both ends of a bone are on the side opposite to its name.
pub(super) fn is_across(placed: &Placed<'_>) -> bool {
    let Some((side, (head, tail))) = of(&placed.bone.name)
        .map(|(side, _)| side)
        .zip(placed.found())
    else {
        return false;
    };
    [head, tail].iter().all(|end| {
        if side == Side::Left {
            end[0] < -MIDDLE
        } else {
            end[0] > MIDDLE
        }
    })
}

/// Two places count as one if they are nearer to each other than this, in metres.
const ONE_PLACE: f64 = 1e-4;
/// The head of a bone lies beyond its parent if its distance from the head of the parent is more
/// than this many times the length of the parent.
const BEYOND: f64 = 1.05;

/// The bones whose head and tail are swapped: the tail lies at the tail of the parent, the head
/// beyond it.
pub(super) fn swapped<'r>(bones: &[Placed<'r>]) -> Vec<&'r str> {
    let known = by_name(bones);
    let parent = |placed: &Placed<'_>| known.get(placed.bone.parent.as_deref()?).copied();
    let children: Grouped<&str, &Placed<'_>> = grouped(
        bones
            .iter()
            .filter_map(|child| Some((child.bone.parent.as_deref()?, child))),
    );
    let is_swapped = |placed: &&Placed<'_>| {
        let ends = placed.found().zip(parent(placed).and_then(Placed::found));
        let Some(((head, tail), (parent_head, parent_tail))) = ends else {
            return false;
        };
        let length = apart(parent_head, parent_tail);
        let begins_there = |child: &&Placed<'_>| {
            child
                .found()
                .is_some_and(|(head, _)| apart(head, tail) < ONE_PLACE)
        };
        let own = children
            .get(placed.bone.name.as_str())
            .map(Vec::as_slice)
            .unwrap_or_default();
        apart(tail, parent_tail) < ONE_PLACE
            && apart(head, tail) > ONE_PLACE
            && length > ONE_PLACE
            && apart(head, parent_head) > BEYOND * length
            && !own.iter().any(begins_there)
    };
    bones
        .iter()
        .filter(is_swapped)
        .map(|placed| placed.bone.name.as_str())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn partners_are_found_by_name() {
        let partner = |name: &str| of(name).map(|(_, partner)| partner);
        for (left, right) in [
            ("hand.L", "hand.R"),
            ("hand_l", "hand_r"),
            ("mixamorig:LeftHand", "mixamorig:RightHand"),
            ("LToe", "RToe"),
        ] {
            assert_eq!(partner(left).as_deref(), Some(right));
            assert_eq!(partner(right).as_deref(), Some(left));
        }
        for centre in ["Root", "LowerBack", "spine", "", "L", "é"] {
            assert_eq!(partner(centre), None, "{centre}");
        }
    }
}
