//! Rest pose of a skeleton: bone order, plane normals, rest matrices.
//!
//! Gets joint positions and bones as indices; returns matrices. What the application would turn into NaN is NaN here:
//! zero length bones, planes without area. Source: MakeHuman 2, skeleton (formats/makehuman2.md §10, §10.1).

use super::error::EvalError;
use super::vector::{Mat4, Point, Vec3, cross, distance, from_columns, inverse, length, multiply, sub, unit, widen};

/// Sine of an angle below which two directions are parallel: what float32 arithmetic cannot tell from zero. Joints
/// are rounded to float32 before, so equal coordinates give exactly zero; an angle of a single rounding step (4e-7 at
/// a bone of two units) still decides the roll, as it does in the application.
pub const PARALLEL_SINE: f64 = 1e-7;

/// Plane normal of a bone without rotation plane.
pub const DEFAULT_NORMAL: Vec3 = [0.0, 1.0, 0.0];

/// A bone by numbers.
#[derive(Clone, Copy, Debug)]
pub struct Bone {
    /// Index of the parent bone.
    pub parent: Option<usize>,
    /// Index of the head joint.
    pub head: usize,
    /// Index of the tail joint.
    pub tail: usize,
    /// Indices of the first three joints of its rotation plane.
    pub plane: Option<[usize; 3]>,
}

/// A bone in rest pose.
#[derive(Clone, Copy, Debug)]
pub struct RestBone {
    /// Position of the head in mesh units.
    pub head: Point,
    /// Position of the tail in mesh units.
    pub tail: Point,
    /// Distance of both.
    pub length: f64,
    /// Bone space to mesh space: columns are the x, y, z axes and the head.
    pub global: Mat4,
    /// Bone space to the space of the parent bone; for the root, `global`.
    pub local: Mat4,
}

/// Bones in the order of the application: breadth first from the root, siblings in file order. Bones that the root
/// does not reach (a cycle, or below one) are missing: the application drops them without a word.
///
/// # Errors
/// No root, a second root, or a parent that does not exist: the application refuses the skeleton.
pub fn hierarchy(parents: &[Option<usize>]) -> Result<Vec<usize>, EvalError> {
    let mut children = vec![Vec::new(); parents.len()];
    let mut root = None;
    for (bone, parent) in parents.iter().enumerate() {
        match parent {
            Some(parent) => children.get_mut(*parent).ok_or(EvalError::BoneOutOfRange(*parent))?.push(bone),
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

/// Sine of the angle between the edges of a plane, 0..1. Below `PARALLEL_SINE` the plane has no area; NaN if two of
/// its joints coincide.
pub fn plane_sine(a: Point, b: Point, c: Point) -> f64 {
    length(cross(direction(b, c), direction(a, b)))
}

/// Unit normal of the plane through three joints; NaN if the joints coincide or lie in a line (the application has
/// NaN or noise there).
pub fn plane_normal(a: Point, b: Point, c: Point) -> Vec3 {
    let normal = cross(direction(b, c), direction(a, b));
    if length(normal) < PARALLEL_SINE { [f64::NAN; 3] } else { unit(normal) }
}

/// Sine of the angle between a bone and the normal of its plane, 0..1. Close to 0 the roll of the bone is noise; NaN
/// for a bone without length.
pub fn roll_sine(head: Point, tail: Point, normal: Vec3) -> f64 {
    length(cross(normal, direction(head, tail)))
}

/// Global rest matrix: y from head to tail, z = normal x y, x = y x z.
///
/// A normal parallel to the bone gives z = (0, 0, 1); a bone that is also parallel to that has NaN for x. NaN in the
/// normal or a bone without length gives NaN in all axes.
pub fn rest_matrix(head: Point, tail: Point, normal: Vec3) -> Mat4 {
    let y = direction(head, tail);
    let across = cross(normal, y);
    // `<` is false for NaN, which then stays NaN.
    let z = if length(across) < PARALLEL_SINE { [0.0, 0.0, 1.0] } else { unit(across) };
    let sideways = cross(y, z);
    let x = if length(sideways) < PARALLEL_SINE { [f64::NAN; 3] } else { unit(sideways) };
    from_columns(x, y, z, widen(head))
}

/// All bones in rest pose, in the order given.
///
/// # Errors
/// A joint or parent index that does not exist.
pub fn rest_bones(joints: &[Point], bones: &[Bone]) -> Result<Vec<RestBone>, EvalError> {
    let mut rest = bones.iter().map(|bone| global_rest(joints, bone)).collect::<Result<Vec<_>, _>>()?;
    for (i, bone) in bones.iter().enumerate() {
        if let Some(parent) = bone.parent {
            let parent = rest.get(parent).ok_or(EvalError::BoneOutOfRange(parent))?.global;
            rest[i].local = multiply(&inverse(&parent), &rest[i].global);
        }
    }
    Ok(rest)
}

fn global_rest(joints: &[Point], bone: &Bone) -> Result<RestBone, EvalError> {
    let joint = |index: usize| joints.get(index).copied().ok_or(EvalError::JointOutOfRange(index));
    let normal = match bone.plane {
        Some([a, b, c]) => plane_normal(joint(a)?, joint(b)?, joint(c)?),
        None => DEFAULT_NORMAL,
    };
    let (head, tail) = (joint(bone.head)?, joint(bone.tail)?);
    let global = rest_matrix(head, tail, normal);
    Ok(RestBone { head, tail, length: distance(head, tail), global, local: global })
}

/// Unit vector from `a` to `b`; NaN if they coincide.
fn direction(a: Point, b: Point) -> Vec3 {
    unit(sub(widen(b), widen(a)))
}

#[cfg(test)]
mod tests {
    use super::super::vector::{IDENTITY, dot, is_finite};
    use super::*;

    fn column(m: &Mat4, i: usize) -> Vec3 {
        [m[0][i], m[1][i], m[2][i]]
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed() {
        let m = rest_matrix([1.0, 2.0, 3.0], [1.5, 1.0, 3.2], plane_normal([0.0; 3], [1.0, 0.2, 0.0], [1.2, 1.0, 0.4]));
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
        assert!(!is_finite(&rest_matrix([1.0; 3], [1.0; 3], DEFAULT_NORMAL)));
        assert!(roll_sine([1.0; 3], [1.0; 3], DEFAULT_NORMAL).is_nan());
    }

    #[test]
    fn plane_without_area_is_nan_not_the_default() {
        let line = plane_normal([0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]);
        assert!(line.iter().all(|x| x.is_nan()));
        assert!(plane_normal([0.0; 3], [0.0; 3], [1.0; 3]).iter().all(|x| x.is_nan()));
        assert!(rest_matrix([0.0; 3], [0.0, 1.0, 0.0], line)[0][0].is_nan());
        assert!(plane_sine([0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]) < PARALLEL_SINE);
    }

    #[test]
    fn plane_is_taken_counter_clockwise() {
        assert_eq!(plane_normal([0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]), [0.0, 0.0, -1.0]);
    }

    #[test]
    fn bones_are_ordered_from_the_root() {
        assert_eq!(hierarchy(&[Some(2), Some(0), None, Some(2)]), Ok(vec![2, 0, 3, 1]));
    }

    #[test]
    fn bones_in_or_below_a_cycle_are_dropped() {
        assert_eq!(hierarchy(&[None, Some(2), Some(1), Some(2), Some(4)]), Ok(vec![0]));
    }

    #[test]
    fn roots_are_counted() {
        assert_eq!(hierarchy(&[Some(1), Some(0)]), Err(EvalError::NoRoot));
        assert_eq!(hierarchy(&[]), Err(EvalError::NoRoot));
        assert_eq!(hierarchy(&[None, None]), Err(EvalError::SecondRoot(1)));
        assert_eq!(hierarchy(&[None, Some(9)]), Err(EvalError::BoneOutOfRange(9)));
    }

    #[test]
    fn local_matrices_multiply_to_the_global_one() {
        let joints = [[0.0; 3], [0.0, 1.0, 0.5], [1.0, 2.0, 0.0]];
        let bones = [
            Bone { parent: Some(1), head: 1, tail: 2, plane: None },
            Bone { parent: None, head: 0, tail: 1, plane: Some([0, 1, 2]) },
        ];
        let rest = rest_bones(&joints, &bones).unwrap();
        let product = multiply(&rest[1].local, &rest[0].local);
        for (a, b) in product.iter().flatten().zip(rest[0].global.iter().flatten()) {
            assert!((a - b).abs() < 1e-12);
        }
    }

    #[test]
    fn unknown_joint_is_an_error() {
        let bone = Bone { parent: None, head: 0, tail: 5, plane: None };
        assert_eq!(rest_bones(&[[0.0; 3]], &[bone]).unwrap_err(), EvalError::JointOutOfRange(5));
    }
}
