//! Posing: matrices of posed bones and linear blend skinning.
//!
//! Gets rest bones, a pose for some of them, weights and the morphed mesh; returns matrices and
//! positions. Source: MakeHuman 2, pose mode (`docs/loaders/makehuman2/weights.md#skinning`).

use super::error::EvalError;
use super::skeleton::{Bone, RestBone};
use super::vector::{
    IDENTITY, Mat3, Mat4, Point, Vec3, add, inverse, multiply, narrow, rotate, scale, transform,
    widen,
};
use super::weights::BoneWeights;

/// The pose of one bone: rotation and translation in global axes, relative to the rest pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Rotation matrix; used as it is, also if it is none.
    pub rotation: Mat3,
    /// Displacement in mesh units.
    pub translation: Vec3,
}

/// The matrices of one bone in a pose.
#[derive(Clone, Copy, Debug)]
pub struct PosedBone {
    /// Bone space to mesh space; column 3 is the posed head.
    pub global: Mat4,
    /// Rest position to posed position, in mesh space.
    pub moved: Mat4,
}

/// Poses all bones; those without a pose keep the rest pose relative to their parent. `bones` and
/// `rest` belong together, parents come first.
///
/// # Errors
/// A parent that does not come before its bone.
pub fn pose_bones(
    bones: &[Bone],
    rest: &[RestBone],
    poses: &[Option<Pose>],
) -> Result<Vec<PosedBone>, EvalError> {
    let mut result: Vec<PosedBone> = Vec::with_capacity(rest.len());
    for (i, (bone, rest)) in bones.iter().zip(rest).enumerate() {
        let to_bone = inverse(&rest.global);
        let local = poses
            .get(i)
            .copied()
            .flatten()
            .map_or(IDENTITY, |pose| local_pose(&to_bone, rest, &pose));
        let in_parent = multiply(&rest.local, &local);
        let global = match bone.parent {
            Some(parent) => multiply(
                &result
                    .get(parent)
                    .ok_or(EvalError::BoneOutOfRange(parent))?
                    .global,
                &in_parent,
            ),
            None => in_parent,
        };
        result.push(PosedBone {
            global,
            moved: multiply(&global, &to_bone),
        });
    }
    Ok(result)
}

/// inv(R) * P * R, its translation replaced by inv(R) times the displacement.
fn local_pose(to_bone: &Mat4, rest: &RestBone, pose: &Pose) -> Mat4 {
    let row = |i: usize| {
        [
            pose.rotation[i][0],
            pose.rotation[i][1],
            pose.rotation[i][2],
            0.0,
        ]
    };
    let turned = [row(0), row(1), row(2), IDENTITY[3]];
    let mut local = multiply(to_bone, &multiply(&turned, &rest.global));
    for (row, moved) in local.iter_mut().zip(rotate(to_bone, pose.translation)) {
        row[3] = moved;
    }
    local
}

/// Linear blend skinning: the weighted sum of where each bone moves the vertex. Weights are used as
/// they are, so missing weight pulls a vertex towards the origin. If a bone lists a vertex twice
/// only the last entry counts.
///
/// `moved[b]` belongs to `weights[i].bone == b`.
///
/// # Errors
/// A weighted vertex or bone that does not exist; bones without entries do not matter.
pub fn skin(
    positions: &[Point],
    weights: &[BoneWeights],
    moved: &[Mat4],
) -> Result<Vec<Point>, EvalError> {
    let mut sums: Vec<Vec3> = vec![[0.0; 3]; positions.len()];
    for list in weights.iter().filter(|list| !list.entries.is_empty()) {
        let matrix = moved
            .get(list.bone)
            .ok_or(EvalError::BoneOutOfRange(list.bone))?;
        // All sums are taken as they were before this bone, then stored in order: so the last entry
        // of a vertex wins.
        let mut stored = Vec::with_capacity(list.entries.len());
        for (vertex, weight) in &list.entries {
            let place = *vertex as usize;
            let position = positions
                .get(place)
                .ok_or_else(|| EvalError::vertex(*vertex, positions.len()))?;
            let part = scale(transform(matrix, widen(*position)), f64::from(*weight));
            stored.push((place, add(sums[place], part)));
        }
        for (place, sum) in stored {
            sums[place] = sum;
        }
    }
    Ok(sums.into_iter().map(narrow).collect())
}

#[cfg(test)]
mod tests {
    use super::super::makehuman2::rest::rest_bones;
    use super::*;

    const MESH: [Point; 3] = [[0.0, 1.0, 0.0], [0.5, 2.0, 0.25], [-1.0, 3.0, 2.0]];
    const JOINTS: [Point; 3] = [[0.0; 3], [0.0, 1.0, 0.1], [0.3, 2.0, 0.0]];
    const QUARTER_ABOUT_Z: Mat3 = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

    fn bones() -> [Bone; 2] {
        let bone = |parent, head, tail| Bone {
            parent,
            head,
            tail,
            plane: None,
        };
        [bone(None, 0, 1), bone(Some(0), 1, 2)]
    }

    fn pose(rotation: Mat3, translation: Vec3) -> Pose {
        Pose {
            rotation,
            translation,
        }
    }

    fn posed(poses: &[Option<Pose>], weights: &[BoneWeights]) -> Vec<Point> {
        let rest = rest_bones(&JOINTS, &bones()).unwrap();
        let moved: Vec<Mat4> = pose_bones(&bones(), &rest, poses)
            .unwrap()
            .iter()
            .map(|p| p.moved)
            .collect();
        skin(&MESH, weights, &moved).unwrap()
    }

    fn list(bone: usize, entries: &[(u32, f32)]) -> BoneWeights {
        BoneWeights {
            bone,
            entries: entries.to_vec(),
        }
    }

    fn assert_close(found: &[Point], expected: &[Point]) {
        for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((a - b).abs() < 1e-6, "{found:?} {expected:?}");
        }
    }

    #[test]
    fn rest_pose_is_identity() {
        let weights = [
            list(0, &[(0, 1.0), (1, 0.25)]),
            list(1, &[(1, 0.75), (2, 1.0)]),
        ];
        assert_close(&posed(&[], &weights), &MESH);
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_close(&posed(&[Some(pose(unit, [0.0; 3])); 2], &weights), &MESH);
    }

    #[test]
    fn rotation_turns_about_the_head() {
        let found = posed(
            &[None, Some(pose(QUARTER_ABOUT_Z, [0.0; 3]))],
            &[list(1, &[(0, 1.0), (1, 1.0), (2, 1.0)])],
        );
        // Around (0, 1, 0.1): (x, y) becomes (1 - y, 1 + x).
        assert_close(
            &found,
            &[[0.0, 1.0, 0.0], [-1.0, 1.5, 0.25], [-2.0, 0.0, 2.0]],
        );
    }

    #[test]
    fn children_follow_their_parent() {
        let found = posed(
            &[Some(pose(QUARTER_ABOUT_Z, [0.0; 3]))],
            &[list(1, &[(0, 1.0), (1, 1.0), (2, 1.0)])],
        );
        assert_close(
            &found,
            &[[-1.0, 0.0, 0.0], [-2.0, 0.5, 0.25], [-3.0, -1.0, 2.0]],
        );
    }

    #[test]
    fn translation_is_in_global_axes() {
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let found = posed(
            &[Some(pose(unit, [1.0, 2.0, 3.0]))],
            &[list(0, &[(0, 1.0)])],
        );
        assert_close(&found[..1], &[[1.0, 3.0, 3.0]]);
    }

    #[test]
    fn vertex_twice_in_a_bone_counts_once() {
        let found = posed(&[], &[list(0, &[(1, 0.5), (1, 0.5)])]);
        assert_close(&found[1..2], &[[0.25, 1.0, 0.125]]);
    }

    #[test]
    fn missing_weight_pulls_to_the_origin() {
        let found = posed(&[], &[list(0, &[(1, 0.25)])]);
        assert_close(&found, &[[0.0; 3], [0.125, 0.5, 0.0625], [0.0; 3]]);
    }

    #[test]
    fn unknown_bone_matters_only_with_weights() {
        assert_eq!(
            skin(&MESH, &[list(7, &[(0, 1.0)])], &[IDENTITY]),
            Err(EvalError::BoneOutOfRange(7))
        );
        assert!(skin(&MESH, &[list(7, &[])], &[]).is_ok());
        assert_eq!(
            skin(&MESH, &[list(0, &[(3, 1.0)])], &[IDENTITY]),
            Err(EvalError::vertex(3, 3))
        );
    }

    #[test]
    fn degenerate_bone_makes_its_vertices_nan() {
        let joints = [[0.0; 3], [0.0; 3], [0.3, 2.0, 0.0]];
        let rest = rest_bones(&joints, &bones()).unwrap();
        let moved: Vec<Mat4> = pose_bones(&bones(), &rest, &[])
            .unwrap()
            .iter()
            .map(|p| p.moved)
            .collect();
        assert!(skin(&MESH, &[list(0, &[(1, 1.0)])], &moved).unwrap()[1][0].is_nan());
    }

    #[test]
    fn parent_after_its_child_is_an_error() {
        let rest = rest_bones(&JOINTS, &bones()).unwrap();
        let [root, child] = bones();
        let swapped = [
            Bone {
                parent: Some(1),
                ..child
            },
            root,
        ];
        assert!(pose_bones(&swapped, &rest, &[]).is_err());
    }
}
