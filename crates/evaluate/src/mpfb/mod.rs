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
pub use mhlint_eval::mpfb::mix::USUAL_SCALE;
pub use pose::{PosedRig, StoredPose, read_stored_pose};
pub use rig::{RigFile, StandingRig, read_rig};
pub use weights::{Lists, groups_json, read_groups};

use super::gauge::gauge;
use super::{Error, Rows};
use mhlint_config::Config;
use mhlint_eval::measures::Measures;
use mhlint_repo::Layers;
use mhlint_repo::mpfb::View;

/// Measures the body with what it wears; `rows` are those of its targets.
pub(super) fn measure(layers: Layers<'_>, rows: &Rows, options: &Config) -> Option<Measures> {
    let view = View::connect(layers);
    let composed = base::compose(&view, rows)?;
    let mesh = worn::mesh(&view);
    let fitted = mesh
        .map(|mesh| worn::fit(mesh, view.worn(), layers))
        .unwrap_or_default();
    let worn = mesh
        .map(|mesh| worn::measure(mesh, &fitted))
        .unwrap_or_default();
    Some(Measures {
        worn,
        ..gauge(&composed, options)
    })
}

/// Rigs of MPFB follow formulas of their own.
pub(super) fn no_rigs(base: &str) -> Error {
    Error::NoSkeleton {
        base: base.to_owned(),
        reason: NO_RIGS.to_owned(),
    }
}

const NO_RIGS: &str = "a rig of MPFB is chosen with `--rig FILE`";
