//! How files of MPFB become the arrays that are evaluated, and its kinds of cases.

mod asset;
pub(super) mod base;
pub(super) mod cases;
mod figure;
mod keys;
pub(super) mod macros;
pub(super) mod names;
mod pose;
mod rig;
mod rig_cases;
mod weights;
pub(super) mod worn;

pub use asset::{Asset, FittedAsset, read_asset};
pub use figure::USUAL_SCALE;
pub use pose::{PosedRig, StoredPose, read_stored_pose};
pub use rig::{RigFile, StandingRig, read_rig};
pub use weights::{Lists, groups_json, read_groups};

use super::Error;

/// Rigs of MPFB follow formulas of their own.
pub(super) fn no_rigs(base: &str) -> Error {
    Error::NoSkeleton { base: base.to_owned(), reason: NO_RIGS.to_owned() }
}

const NO_RIGS: &str = "a rig of MPFB is chosen with `--rig FILE`";
