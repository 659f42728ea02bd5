//! Rest pose of a skeleton: bone order, plane normals, rest matrices.
//!
//! Gets joint positions and bones as indices; returns matrices. What the application would turn
//! into NaN is NaN here: zero length bones, planes without area. Source:
//! `docs/loaders/makehuman2/skeletons.md#faults-of-skeletons`,
//! `docs/loaders/makehuman2/skeletons.md#rest-pose`.

use super::super::error::EvalError;
use super::super::skeleton::{Bone, PARALLEL_SINE, RestBone, direction};
use super::super::vector::{
    Mat4, Point, Vec3, cross, distance, from_columns, inverse, length, multiply, unit, widen,
};

/// Plane normal of a bone without rotation plane.
pub const DEFAULT_NORMAL: Vec3 = [0.0, 1.0, 0.0];

/// Bones in the order of the application: breadth first from the root, siblings in file order.
/// Bones that the root does not reach (a cycle, or below one) are missing: the application drops
/// them without a word.
///
/// # Errors
/// No root, a second root, or a parent that does not exist: the application refuses the skeleton.
pub fn hierarchy(parents: &[Option<usize>]) -> Result<Vec<usize>, EvalError> {
    let mut children = vec![Vec::new(); parents.len()];
    let mut root = None;
    for (bone, parent) in parents.iter().enumerate() {
        match parent {
            Some(parent) => children
                .get_mut(*parent)
                .ok_or(EvalError::BoneOutOfRange(*parent))?
                .push(bone),
            None if root.is_some() => return Err(EvalError::SecondRoot(bone)),
            None => root = Some(bone),
        }
    }
    let mut order = vec![root.ok_or(EvalError::NoRoot)?];
    let mut next = 0;
    while let Some(bone) = order.get(next) {
        order.extend_from_slice(&children[*bone]);
        next += 1;
    }
    Ok(order)
}

/// Unit normal of the plane through three joints; NaN if the joints coincide or lie in a line (the
/// application has NaN or noise there).
pub fn plane_normal(a: Point, b: Point, c: Point) -> Vec3 {
    let normal = cross(direction(b, c), direction(a, b));
    if length(normal) < PARALLEL_SINE {
        [f64::NAN; 3]
    } else {
        unit(normal)
    }
}

/// Global rest matrix: y from head to tail, z = normal x y, x = y x z.
///
/// A normal parallel to the bone gives z = (0, 0, 1); a bone that is also parallel to that has NaN
/// for x. NaN in the normal or a bone without length gives NaN in all axes.
pub fn rest_matrix(head: Point, tail: Point, normal: Vec3) -> Mat4 {
    let y = direction(head, tail);
    let across = cross(normal, y);
    // `<` is false for NaN, which then stays NaN.
    let z = if length(across) < PARALLEL_SINE {
        [0.0, 0.0, 1.0]
    } else {
        unit(across)
    };
    let sideways = cross(y, z);
    let x = if length(sideways) < PARALLEL_SINE {
        [f64::NAN; 3]
    } else {
        unit(sideways)
    };
    from_columns(x, y, z, widen(head))
}

/// All bones in rest pose, in the order given.
///
/// # Errors
/// A joint or parent index that does not exist.
pub fn rest_bones(joints: &[Point], bones: &[Bone]) -> Result<Vec<RestBone>, EvalError> {
    let mut rest = bones
        .iter()
        .map(|bone| global_rest(joints, bone))
        .collect::<Result<Vec<_>, _>>()?;
    for (i, bone) in bones.iter().enumerate() {
        if let Some(parent) = bone.parent {
            let parent = rest
                .get(parent)
                .ok_or(EvalError::BoneOutOfRange(parent))?
                .global;
            rest[i].local = multiply(&inverse(&parent), &rest[i].global);
        }
    }
    Ok(rest)
}

/// Plane normal of a bone.
///
/// # Errors
/// A joint index that does not exist.
pub fn normal(joints: &[Point], bone: &Bone) -> Result<Vec3, EvalError> {
    let joint = |index| joint(joints, index);
    bone.plane.map_or(Ok(DEFAULT_NORMAL), |[a, b, c]| {
        Ok(plane_normal(joint(a)?, joint(b)?, joint(c)?))
    })
}

fn joint(joints: &[Point], index: usize) -> Result<Point, EvalError> {
    joints
        .get(index)
        .copied()
        .ok_or(EvalError::JointOutOfRange(index))
}

fn global_rest(joints: &[Point], bone: &Bone) -> Result<RestBone, EvalError> {
    let normal = normal(joints, bone)?;
    let (head, tail) = (joint(joints, bone.head)?, joint(joints, bone.tail)?);
    let global = rest_matrix(head, tail, normal);
    Ok(RestBone {
        head,
        tail,
        length: distance(head, tail),
        global,
        local: global,
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::skeleton::{plane_sine, roll_sine};
    use super::super::super::vector::{IDENTITY, dot};
    use super::*;

    fn column(m: &Mat4, i: usize) -> Vec3 {
        [m[0][i], m[1][i], m[2][i]]
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed() {
        let m = rest_matrix(
            [1.0, 2.0, 3.0],
            [1.5, 1.0, 3.2],
            plane_normal([0.0; 3], [1.0, 0.2, 0.0], [1.2, 1.0, 0.4]),
        );
        let [x, y, z] = [0, 1, 2].map(|i| column(&m, i));
        assert!((dot(cross(x, y), z) - 1.0).abs() < 1e-12);
        assert_eq!(column(&m, 3), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn bone_along_the_default_normal_takes_the_z_axis() {
        let m = rest_matrix([0.0; 3], [0.0, 2.0, 0.0], DEFAULT_NORMAL);
        assert_eq!(m, IDENTITY);
        let noisy = rest_matrix([0.0; 3], [1e-8, 2.0, -1e-8], DEFAULT_NORMAL);
        assert_eq!(column(&noisy, 2), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn bone_along_normal_and_z_has_no_x_axis() {
        let m = rest_matrix([0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
        assert!(column(&m, 0).iter().all(|x| x.is_nan()));
        assert_eq!(column(&m, 1), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn bone_without_length_is_nan() {
        assert!(
            rest_matrix([1.0; 3], [1.0; 3], DEFAULT_NORMAL)
                .iter()
                .flatten()
                .any(|x| !x.is_finite())
        );
        assert!(roll_sine([1.0; 3], [1.0; 3], DEFAULT_NORMAL).is_nan());
    }

    #[test]
    fn plane_without_area_is_nan_not_the_default() {
        let line = plane_normal([0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]);
        assert!(line.iter().all(|x| x.is_nan()));
        assert!(
            plane_normal([0.0; 3], [0.0; 3], [1.0; 3])
                .iter()
                .all(|x| x.is_nan())
        );
        assert!(rest_matrix([0.0; 3], [0.0, 1.0, 0.0], line)[0][0].is_nan());
        assert!(plane_sine([0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]) < PARALLEL_SINE);
    }

    #[test]
    fn plane_is_taken_counter_clockwise() {
        assert_eq!(
            plane_normal([0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]),
            [0.0, 0.0, -1.0]
        );
    }

    #[test]
    fn bones_are_ordered_from_the_root() {
        assert_eq!(
            hierarchy(&[Some(2), Some(0), None, Some(2)]),
            Ok(vec![2, 0, 3, 1])
        );
    }

    #[test]
    fn bones_in_or_below_a_cycle_are_dropped() {
        assert_eq!(
            hierarchy(&[None, Some(2), Some(1), Some(2), Some(4)]),
            Ok(vec![0])
        );
    }

    #[test]
    fn roots_are_counted() {
        assert_eq!(hierarchy(&[Some(1), Some(0)]), Err(EvalError::NoRoot));
        assert_eq!(hierarchy(&[]), Err(EvalError::NoRoot));
        assert_eq!(hierarchy(&[None, None]), Err(EvalError::SecondRoot(1)));
        assert_eq!(
            hierarchy(&[None, Some(9)]),
            Err(EvalError::BoneOutOfRange(9))
        );
    }

    #[test]
    fn local_matrices_multiply_to_the_global_one() {
        let joints = [[0.0; 3], [0.0, 1.0, 0.5], [1.0, 2.0, 0.0]];
        let bones = [
            Bone {
                parent: Some(1),
                head: 1,
                tail: 2,
                plane: None,
            },
            Bone {
                parent: None,
                head: 0,
                tail: 1,
                plane: Some([0, 1, 2]),
            },
        ];
        let rest = rest_bones(&joints, &bones).unwrap();
        let product = multiply(&rest[1].local, &rest[0].local);
        for (a, b) in product
            .iter()
            .flatten()
            .zip(rest[0].global.iter().flatten())
        {
            assert!((a - b).abs() < 1e-12);
        }
    }

    #[test]
    fn unknown_joint_is_an_error() {
        let bone = Bone {
            parent: None,
            head: 0,
            tail: 5,
            plane: None,
        };
        assert_eq!(
            rest_bones(&[[0.0; 3]], &[bone]).unwrap_err(),
            EvalError::JointOutOfRange(5)
        );
    }
}
