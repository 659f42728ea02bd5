//! How far two evaluations of the same files may lie apart.
//!
//! The applications store coordinates, offsets, weights and matrices as float32 and add up in
//! float32. The numbers are those that the reference files suggest (reference/README.md,
//! "Tolerances").

use super::Kind;

/// Allowed distance of two numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tolerance {
    /// In the unit of the number.
    Absolute(f64),
    /// As a share of the expected number.
    Relative(f64),
    /// In the unit of the mesh: for one in metres, and for one in decimetres.
    ByScale {
        /// One unit of the file is a tenth of a unit of the mesh.
        metres: f64,
        /// It is a whole one.
        decimetres: f64,
    },
}

/// Factors of targets; `f64` in the application.
pub(crate) const FACTORS: Tolerance = Tolerance::Absolute(1e-6);
/// Coordinates and boxes of morphed meshes, decimetres.
pub(crate) const MORPHED: Tolerance = Tolerance::Absolute(2e-5);
/// Coordinates and boxes of shape keys as Blender mixes them.
pub(crate) const MIXED: Tolerance = Tolerance::ByScale {
    metres: 3e-6,
    decimetres: 2e-5,
};
/// Ends of bones as MPFB computes them.
pub(crate) const RIG_ENDS: Tolerance = Tolerance::ByScale {
    metres: 1e-6,
    decimetres: 1e-5,
};
/// The same as Blender stores them.
pub(crate) const BONE_ENDS: Tolerance = Tolerance::ByScale {
    metres: 2e-6,
    decimetres: 2e-5,
};
/// Axes of bones at rest: those of short ones that nearly point to -y turn at the least difference.
pub(crate) const REST_AXES: Tolerance = Tolerance::Absolute(1e-3);
/// Number of entries and sum of the weights of a vertex group.
pub(crate) const GROUP_SUMS: Tolerance = Tolerance::Relative(1e-6);
/// The same of an asset that takes its weights from the body.
pub(crate) const TAKEN_SUMS: Tolerance = Tolerance::Absolute(2e-4);
/// Assets in Blender.
pub(crate) const FITTED_IN_BLENDER: Tolerance = Tolerance::ByScale {
    metres: 2e-6,
    decimetres: 2e-5,
};
/// Pose matrices and skinned vertices in Blender.
pub(crate) const POSED_IN_BLENDER: Tolerance = Tolerance::Absolute(5e-6);
/// Their sums over all vertices of a mesh.
pub(crate) const MIXED_SUMS: Tolerance = Tolerance::Absolute(0.05);
/// Sums over all vertices of a mesh, decimetres.
const MESH_SUMS: Tolerance = Tolerance::Absolute(0.2);
/// Joints, heads, tails, lengths, decimetres.
pub(crate) const JOINTS: Tolerance = Tolerance::Absolute(2e-5);
/// Rest matrices.
pub(crate) const REST_MATRICES: Tolerance = Tolerance::Absolute(1e-4);
/// Skinned coordinates and pose matrices.
pub(crate) const SKINNED: Tolerance = Tolerance::Absolute(5e-5);
/// Fitted assets and their scales.
pub(crate) const FITTED: Tolerance = Tolerance::Absolute(2e-5);
/// Single weights, and the sums of a vertex.
pub(crate) const WEIGHTS: Tolerance = Tolerance::Absolute(1e-6);
/// Sum of the weights of a bone.
const BONE_SUMS: Tolerance = Tolerance::Relative(1e-6);
/// Sum of the weights of a bone that has one entry more or less, in files of assets: the weight on
/// the threshold.
pub(super) const AT_THRESHOLD: Tolerance = Tolerance::Absolute(1e-4);
/// Counts.
const EXACT: Tolerance = Tolerance::Absolute(0.0);

impl Kind {
    /// The tolerance of a quantity, in a case whose mesh has this scale.
    pub(super) fn tolerance(&self, quantity: &str, scale: f64) -> Tolerance {
        let own = self.tolerances.iter().find(|(name, _)| *name == quantity);
        let common = || match quantity {
            "count" | "vertex_count" | "ref_count" | "delete_verts" => EXACT,
            "sum" | "sum_xyz" => MESH_SUMS,
            "bone sum" => BONE_SUMS,
            _ => self.tolerance,
        };
        own.map_or_else(common, |(_, own)| *own).at(scale)
    }
}

impl Tolerance {
    /// The tolerance for a mesh of this scale.
    fn at(self, scale: f64) -> Self {
        match self {
            Self::ByScale { metres, decimetres } => {
                Self::Absolute(if scale > 0.1 { decimetres } else { metres })
            }
            other => other,
        }
    }

    /// The limit itself.
    pub(super) const fn limit(self) -> f64 {
        match self {
            Self::Absolute(limit) | Self::Relative(limit) | Self::ByScale { metres: limit, .. } => {
                limit
            }
        }
    }

    /// Distance of two numbers in the unit of the limit; infinite if only one is finite.
    pub(super) fn deviation(self, expected: Option<f64>, found: Option<f64>) -> f64 {
        match (expected, found) {
            (None, None) => 0.0,
            (Some(expected), Some(found)) => match self {
                Self::Absolute(_) | Self::ByScale { .. } => (expected - found).abs(),
                Self::Relative(_) => {
                    let distance = (expected - found).abs();
                    // Equal zeros have no ratio.
                    if distance > 0.0 {
                        distance / expected.abs()
                    } else {
                        distance
                    }
                }
            },
            _ => f64::INFINITY,
        }
    }
}
