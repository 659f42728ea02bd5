//! How files of MakeHuman 1 become the arrays that are evaluated, and its kinds of cases.

mod asset;
pub(super) mod base;
pub(super) mod cases;
pub(super) mod macros;
pub(super) mod modifiers;
pub(super) mod skeleton;
mod weights;
pub(super) mod worn;

pub use asset::{Asset, read_asset};
pub(super) use weights::posing_weights;
pub use weights::{loaded, reduced, remapped, weight_references};

use super::gauge::gauge;
use super::{Error, Rows};
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_eval::error::EvalError;
use mhlint_eval::measures::Measures;
use mhlint_repo::Layers;
use mhlint_repo::makehuman1::View;

/// Whose files these are.
const OWN: Application = Application::Makehuman1;

/// Measures the body with what it wears; `rows` are those of its targets.
pub(super) fn measure(layers: Layers<'_>, rows: &Rows, options: &Config) -> Measures {
    let view = View::connect(layers);
    if view.foreign_mesh.is_some() {
        return Measures::default();
    }
    let worn = worn::measure(layers);
    let measured = base::compose(&view, rows)
        .map(|composed| gauge(&composed, options))
        .unwrap_or_default();
    Measures { worn, ..measured }
}

/// Data that stop the application, as Python says it.
fn stops(exception: &'static str, reason: String) -> Error {
    Error::Stops {
        application: OWN,
        exception,
        reason,
    }
}

fn stopped(error: EvalError) -> Error {
    Error::index(OWN, error)
}
