//! What evaluation reads and makes of files, as plain data that all applications have.

use mhlint_eval::skeleton::{RestBone, SceneSkeleton};
use mhlint_eval::vector::{Point, Vec3};
use mhlint_eval::weights::LoadedWeights;
use mhlint_formats::mhskel::Skeleton;

/// A skeleton and where it came from.
#[derive(Debug, Clone)]
pub struct SkeletonFile {
    /// Its path.
    pub path: String,
    /// What is in it.
    pub model: Skeleton,
}

/// A skeleton on a mesh, parents before children.
#[derive(Debug, Clone)]
pub struct RestSkeleton {
    /// Its joints and bones by number.
    pub skeleton: SceneSkeleton,
    /// Positions of the joints, in mesh units.
    pub joints: Vec<Point>,
    /// The bones in rest pose.
    pub bones: Vec<RestBone>,
}

/// Weights with the names of their bones.
#[derive(Debug, Clone, Default)]
pub struct NamedWeights {
    /// Names by bone number.
    pub names: Vec<String>,
    /// The weights.
    pub loaded: LoadedWeights,
}

/// An asset on a mesh.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// Positions of all vertices of the OBJ; those without a line keep their place.
    pub positions: Vec<Point>,
    /// How many of them have a line.
    pub references: usize,
    /// Scales of the axes, if any.
    pub scales: Option<Vec3>,
    /// Base vertices that it hides.
    pub deleted: usize,
}
