//! Skeletons by numbers, and what surveys ask of them: where joints are, and how bones lie.
//!
//! Where applications differ, the skeleton knows whose formulas it follows.

use super::error::EvalError;
use super::makehuman2::{joints, rest};
use super::vector::{Mat4, Point, Vec3, cross, length, sub, unit, widen};

/// Sine of an angle below which two directions are parallel: what float32 arithmetic cannot tell
/// from zero. Joints are rounded to float32 before, so equal coordinates give exactly zero; an
/// angle of a single rounding step (4e-7 at a bone of two units) still decides the roll, as it does
/// in the application.
pub const PARALLEL_SINE: f64 = 1e-7;

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

/// Whose formulas place joints and turn bones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formulas {
    /// `makehuman2`.
    #[default]
    Makehuman2,
    /// The same with several roots, and joints of the mesh
    /// (`docs/loaders/makehuman1/skeletons.md#order-and-orientation`).
    Makehuman1,
}

/// A skeleton by numbers, parents before children.
#[derive(Debug, Clone, Default)]
pub struct SceneSkeleton {
    /// Names of the bones.
    pub names: Vec<String>,
    /// The bones.
    pub bones: Vec<Bone>,
    /// Names of the joints.
    pub joint_names: Vec<String>,
    /// Vertices of the joints.
    pub joints: Vec<Vec<u32>>,
    /// Whose formulas place it.
    pub formulas: Formulas,
}

impl SceneSkeleton {
    /// Positions of its joints on a mesh.
    ///
    /// # Errors
    /// A joint without vertices, or with one outside the mesh.
    pub fn joint_positions(&self, positions: &[Point]) -> Result<Vec<Point>, EvalError> {
        match self.formulas {
            Formulas::Makehuman2 => {
                joints::joint_positions(positions, self.joints.iter().map(Vec::as_slice))
            }
            // A joint that is nowhere lies at the origin.
            Formulas::Makehuman1 => {
                let of = |list: &Vec<u32>| match list.as_slice() {
                    [] => Ok([0.0; 3]),
                    list => joints::joint_position(positions, list),
                };
                self.joints.iter().map(of).collect()
            }
        }
    }

    /// All bones in rest pose, its joints standing at `joints`.
    ///
    /// # Errors
    /// A joint or parent that does not exist.
    pub fn rest_bones(&self, joints: &[Point]) -> Result<Vec<RestBone>, EvalError> {
        match self.formulas {
            Formulas::Makehuman2 | Formulas::Makehuman1 => rest::rest_bones(joints, &self.bones),
        }
    }

    /// The direction that the roll of a bone is taken from.
    ///
    /// # Errors
    /// A joint that does not exist.
    pub fn normal(&self, joints: &[Point], bone: &Bone) -> Result<Vec3, EvalError> {
        match self.formulas {
            Formulas::Makehuman2 | Formulas::Makehuman1 => rest::normal(joints, bone),
        }
    }
}

/// Sine of the angle between the edges of a plane, 0..1. Below `PARALLEL_SINE` the plane has no
/// area; NaN if two of its joints coincide.
pub fn plane_sine(a: Point, b: Point, c: Point) -> f64 {
    length(cross(direction(b, c), direction(a, b)))
}

/// Sine of the angle between a bone and the normal of its plane, 0..1. Close to 0 the roll of the
/// bone is noise; NaN for a bone without length.
pub fn roll_sine(head: Point, tail: Point, normal: Vec3) -> f64 {
    length(cross(normal, direction(head, tail)))
}

/// Unit vector from `a` to `b`; NaN if they coincide.
pub(super) fn direction(a: Point, b: Point) -> Vec3 {
    unit(sub(widen(b), widen(a)))
}
