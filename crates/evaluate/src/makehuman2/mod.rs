//! How files of MakeHuman 2 become the arrays that are evaluated, and its kinds of cases.

pub(super) mod asset;
pub(super) mod base;
pub(super) mod cases;
pub(super) mod compose;
pub(super) mod macros;
mod references;
pub(super) mod skeleton;
pub(super) mod weights;
pub(super) mod worn;

pub use asset::{Asset, read_asset};
pub(super) use cases::inline_weights;
pub use macros::macros_json;
pub use skeleton::{read_skeleton, read_skeleton_with_joints};
pub use weights::{WeightLists, read_weights, to_mhw, transferred};

use super::Error;
use mhlint_diag::Application;
use mhlint_eval::error::EvalError;

/// Data that stop the application, as Python says it.
fn stops(exception: &'static str, reason: String) -> Error {
    Error::Stops {
        application: Application::Makehuman2,
        exception,
        reason,
    }
}

fn stopped(error: EvalError) -> Error {
    Error::index(Application::Makehuman2, error)
}
