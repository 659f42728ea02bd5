//! Bones in a pose as Blender has them, and the mesh that they move.
//!
//! Source: MPFB and Blender 4.5 (`docs/loaders/mpfb/weights.md#assigning`,
//! `docs/loaders/mpfb/poses.md#stored-poses`; `reference/README.md`, `mpfb_pose`). Bones that do
//! not inherit rotation or scale are taken like any other.

use super::armature::parents_first;
use super::rest::RestBone;
use crate::vector::{
    IDENTITY, Mat3, Mat4, Point, Vec3, add, from_columns, inverse, length, multiply, narrow, scale,
    transform, unit, widen,
};

/// A turn of a bone about its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turn {
    /// Angles about x, y and z, radians, and the order in which they are applied: axes by number.
    Euler([usize; 3], Vec3),
    /// w, x, y, z, of any length.
    Quaternion([f64; 4]),
    /// An angle about an axis of any length.
    AxisAngle(f64, Vec3),
}

/// What a pose does with a bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BonePose {
    /// How it turns.
    pub turn: Turn,
    /// How it moves along its own axes; a connected bone does not.
    pub translation: Vec3,
}

impl Turn {
    /// The matrix of the turn.
    pub fn matrix(self) -> Mat3 {
        match self {
            Self::Euler(order, angles) => order.into_iter().fold(UNIT, |whole, axis| {
                product(
                    &about(axis, angles.get(axis).copied().unwrap_or(0.0)),
                    &whole,
                )
            }),
            Self::Quaternion(quaternion) => of_quaternion(quaternion),
            Self::AxisAngle(angle, axis) => {
                if length(axis) == 0.0 {
                    return UNIT;
                }
                let [x, y, z] = scale(unit(axis), (angle / 2.0).sin());
                of_quaternion([(angle / 2.0).cos(), x, y, z])
            }
        }
    }
}

const UNIT: Mat3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn about(axis: usize, angle: f64) -> Mat3 {
    let (sin, cos) = angle.sin_cos();
    match axis {
        0 => [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]],
        1 => [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]],
        _ => [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]],
    }
}

fn product(a: &Mat3, b: &Mat3) -> Mat3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

fn of_quaternion(quaternion: [f64; 4]) -> Mat3 {
    let size = quaternion.iter().map(|one| one * one).sum::<f64>().sqrt();
    // Blender takes a quaternion without length for none.
    let [w, x, y, z] = if size == 0.0 {
        [1.0, 0.0, 0.0, 0.0]
    } else {
        quaternion.map(|one| one / size)
    };
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

/// Axes and head of a bone at rest.
pub fn rest_matrix(bone: &RestBone) -> Mat4 {
    let column = |at: usize| bone.matrix.map(|row| row[at]);
    from_columns(column(0), column(1), column(2), bone.head)
}

/// The matrices of all bones in a pose; those that it does not have keep their place below their
/// parents.
pub fn pose_matrices(bones: &[RestBone], poses: &[Option<BonePose>]) -> Vec<Mat4> {
    let mut found: Vec<Option<Mat4>> = vec![None; bones.len()];
    for at in parents_first(bones) {
        let Some(bone) = bones.get(at) else { continue };
        let own = multiply(
            &rest_matrix(bone),
            &local(bone, poses.get(at).copied().flatten()),
        );
        let above = bone
            .parent
            .and_then(|parent| Some((found.get(parent).copied()??, bones.get(parent)?)));
        let matrix = above.map_or(own, |(above, parent)| {
            multiply(&multiply(&above, &inverse(&rest_matrix(parent))), &own)
        });
        if let Some(slot) = found.get_mut(at) {
            *slot = Some(matrix);
        }
    }
    found
        .into_iter()
        .map(|matrix| matrix.unwrap_or(IDENTITY))
        .collect()
}

fn local(bone: &RestBone, pose: Option<BonePose>) -> Mat4 {
    let Some(pose) = pose else { return IDENTITY };
    let is_connected = bone.use_connect && bone.parent.is_some();
    let translation = if is_connected {
        [0.0; 3]
    } else {
        pose.translation
    };
    let turn = pose.turn.matrix();
    let column = |at: usize| turn.map(|row| row[at]);
    from_columns(column(0), column(1), column(2), translation)
}

/// A vertex whose weights come to less stays where it is.
const LEAST: f64 = 1e-4;

/// A mesh moved by its groups: for each vertex bones with weights, which are divided by their sum.
pub fn skinned(
    positions: &[Point],
    bones: &[RestBone],
    posed: &[Mat4],
    weights: &[Vec<(usize, f64)>],
) -> Vec<Point> {
    let moves: Vec<Mat4> = bones
        .iter()
        .zip(posed)
        .map(|(bone, posed)| multiply(posed, &inverse(&rest_matrix(bone))))
        .collect();
    let place = |(point, own): (&Point, Option<&Vec<(usize, f64)>>)| {
        let own = own.map(Vec::as_slice).unwrap_or_default();
        let total: f64 = own.iter().map(|(_, weight)| weight).sum();
        if !(total > LEAST) {
            return *point;
        }
        let mut sum = [0.0; 3];
        for (bone, weight) in own {
            if let Some(matrix) = moves.get(*bone) {
                sum = add(sum, scale(transform(matrix, widen(*point)), weight / total));
            }
        }
        narrow(sum)
    };
    (0..positions.len())
        .filter_map(|at| Some(place((positions.get(at)?, weights.get(at)))))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mpfb::rest::{Defined, Roll, rest};

    #[test]
    fn turns_agree() {
        let half = std::f64::consts::FRAC_PI_2;
        let turns = [
            Turn::Euler([0, 1, 2], [0.0, 0.0, half]),
            Turn::Quaternion([2.0, 0.0, 0.0, 2.0]),
            Turn::AxisAngle(half, [0.0, 0.0, 3.0]),
        ];
        for turn in turns {
            let [x, ..] = turn.matrix();
            assert!(
                (x[0].abs() < 1e-12) && (x[1] + 1.0).abs() < 1e-12,
                "{turn:?}"
            );
        }
        // The first axis turns first.
        let [row, ..] = Turn::Euler([0, 1, 2], [half, half, 0.0]).matrix();
        assert!((row[1] - 1.0).abs() < 1e-12);
        assert_eq!(Turn::AxisAngle(1.0, [0.0; 3]).matrix(), UNIT);
    }

    #[test]
    fn children_follow_and_light_vertices_stay() {
        let bone = |parent| Defined {
            head: [0.0, 0.0, 0.0],
            tail: [0.0, 1.0, 0.0],
            roll: Roll::Angle(0.0),
            parent,
            use_connect: false,
        };
        let child = Defined {
            head: [0.0, 1.0, 0.0],
            tail: [0.0, 2.0, 0.0],
            use_connect: true,
            ..bone(Some(1))
        };
        // The child stands first.
        let bones = rest(&[child, bone(None)]);
        let turn = Turn::Euler([0, 1, 2], [0.0, 0.0, std::f64::consts::FRAC_PI_2]);
        let moved = BonePose {
            turn,
            translation: [5.0; 3],
        };
        let still = BonePose {
            turn: Turn::Quaternion([1.0, 0.0, 0.0, 0.0]),
            translation: [1.0; 3],
        };
        let posed = pose_matrices(
            &bones,
            &[
                Some(still),
                Some(BonePose {
                    translation: [0.0; 3],
                    ..moved
                }),
            ],
        );
        let mesh = [[0.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
        let weights = [vec![(0, 0.25)], vec![(0, 1e-5)], vec![]];
        let skinned = skinned(&mesh, &bones, &posed, &weights);
        assert!(
            (skinned[0][0] + 2.0).abs() < 1e-6 && skinned[0][1].abs() < 1e-6,
            "{skinned:?}"
        );
        assert_eq!(skinned[1..], mesh[1..]);
    }
}
