//! Bones at rest, as Blender has them: roll, what it is aligned to, connections, and the matrix
//! that follows.
//!
//! Source: MPFB and Blender 4.5 (`docs/loaders/mpfb/rigs.md#roll`; `reference/README.md`,
//! `mpfb_bones`).

use super::armature::{set_axes, without_roll};
use crate::vector::{Mat3, Vec3, cross, dot, length, narrow, sub, unit, widen};

/// What decides the turn of a bone about itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Roll {
    /// An angle, radians.
    Angle(f64),
    /// The z axis points up as far as it can.
    ZUp,
    /// The x axis points to the left as far as it can.
    XLeft,
    /// The z axis points this way as far as it can.
    ZTo(Vec3),
}

/// A bone as a rig defines it, with its ends where the mesh has them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Defined {
    /// Where it begins.
    pub head: Vec3,
    /// Where it ends.
    pub tail: Vec3,
    /// Its turn.
    pub roll: Roll,
    /// The bone that it hangs on.
    pub parent: Option<usize>,
    /// Whether its head moves to the tail of its parent.
    pub use_connect: bool,
}

/// A bone at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestBone {
    /// Where it begins.
    pub head: Vec3,
    /// Where it ends.
    pub tail: Vec3,
    /// Its turn, radians.
    pub roll: f64,
    /// Its axes: x, y and z are the columns.
    pub matrix: Mat3,
    /// The bone that it hangs on, if Blender takes it.
    pub parent: Option<usize>,
    /// Whether it is connected with that.
    pub use_connect: bool,
}

/// Shorter vectors have no direction.
pub const NO_LENGTH: f64 = 1e-6;

/// Bones at rest, in the order of the file. Angles are found before bones are connected.
pub fn rest(bones: &[Defined]) -> Vec<RestBone> {
    let parents = accepted(bones);
    let mut found: Vec<RestBone> = bones
        .iter()
        .zip(parents)
        .map(|(bone, parent)| RestBone {
            head: bone.head,
            tail: bone.tail,
            roll: angle(bone.head, bone.tail, bone.roll),
            matrix: Mat3::default(),
            parent,
            use_connect: bone.use_connect,
        })
        .collect();
    for at in 0..found.len() {
        let tail = found
            .get(at)
            .filter(|bone| bone.use_connect)
            .and_then(|bone| bone.parent);
        let tail = tail
            .and_then(|parent| found.get(parent))
            .map(|parent| parent.tail);
        if let Some((bone, tail)) = found.get_mut(at).zip(tail) {
            bone.head = tail;
        }
    }
    set_axes(&mut found);
    found
}

/// The parents that Blender takes: it refuses one that is below the bone itself.
pub fn accepted(bones: &[Defined]) -> Vec<Option<usize>> {
    // Of each bone some bone above it; the uppermost of all above is its own.
    let mut above: Vec<usize> = (0..bones.len()).collect();
    let mut parents = Vec::with_capacity(bones.len());
    for (at, bone) in bones.iter().enumerate() {
        let parent = bone
            .parent
            .filter(|parent| *parent < bones.len() && uppermost(&mut above, *parent) != at);
        if let Some((slot, parent)) = above.get_mut(at).zip(parent) {
            *slot = parent;
        }
        parents.push(parent);
    }
    parents
}

/// The root above a bone; the way there is made shorter for the next time.
fn uppermost(above: &mut [usize], from: usize) -> usize {
    let mut at = from;
    while let Some(next) = above.get(at).copied().filter(|next| *next != at) {
        let further = above.get(next).copied().unwrap_or(next);
        if let Some(slot) = above.get_mut(at) {
            *slot = further;
        }
        at = further;
    }
    at
}

/// The angle that a bone is turned by.
fn angle(head: Vec3, tail: Vec3, roll: Roll) -> f64 {
    let y = unit(sub(tail, head));
    match roll {
        Roll::Angle(angle) => angle,
        Roll::ZUp => towards(y, [0.0, 0.0, 1.0]),
        // z is where world x cross y points.
        Roll::XLeft => towards(y, cross([1.0, 0.0, 0.0], y)),
        Roll::ZTo(vector) => towards(y, vector),
    }
}

/// The angle at which z comes nearest to a vector; 0 for one along the bone.
fn towards(y: Vec3, vector: Vec3) -> f64 {
    if length(cross(y, vector)) <= NO_LENGTH * length(vector) {
        return 0.0;
    }
    let axes = without_roll(narrow(y)).map(widen);
    dot(vector, axes.map(|row| row[0])).atan2(dot(vector, axes.map(|row| row[2])))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bone(parent: Option<usize>) -> Defined {
        Defined {
            head: [0.0; 3],
            tail: [0.0, 0.0, 1.0],
            roll: Roll::Angle(0.0),
            parent,
            use_connect: true,
        }
    }

    #[test]
    fn the_later_link_of_a_cycle_is_refused() {
        let parents = |parents: &[Option<usize>]| {
            let bones: Vec<Defined> = parents.iter().map(|parent| bone(*parent)).collect();
            accepted(&bones)
        };
        assert_eq!(
            parents(&[Some(1), Some(2), Some(0)]),
            [Some(1), Some(2), None]
        );
        assert_eq!(parents(&[Some(0), Some(0), Some(7)]), [None, Some(0), None]);
        assert_eq!(parents(&[Some(1), None, Some(0)]), [Some(1), None, Some(0)]);
        // A long chain in the worst order takes no longer than any other.
        let chain: Vec<Option<usize>> = (0..200_000)
            .map(|at| (at < 199_999).then_some(at + 1))
            .collect();
        assert_eq!(
            parents(&chain)
                .iter()
                .filter(|parent| parent.is_none())
                .count(),
            1
        );
    }

    #[test]
    fn connected_heads_move_and_keep_their_roll() {
        let child = Defined {
            head: [0.1, 0.05, 0.55],
            tail: [0.2, 0.0, 1.0],
            ..bone(Some(0))
        };
        let rest = rest(&[
            bone(None),
            Defined {
                roll: Roll::Angle(0.2),
                ..child
            },
        ]);
        assert_eq!((rest[1].head, rest[1].roll), ([0.0, 0.0, 1.0], 0.2));
    }

    #[test]
    fn a_bone_along_the_world_axis_has_no_roll() {
        let up = rest(&[Defined {
            roll: Roll::ZUp,
            parent: None,
            ..bone(None)
        }]);
        assert_eq!(up[0].roll, 0.0);
        let left = Defined {
            tail: [1.0, 0.0, 0.0],
            roll: Roll::XLeft,
            ..bone(None)
        };
        assert_eq!(rest(&[left])[0].roll, 0.0);
    }
}
