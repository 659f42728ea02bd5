//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod catalogue;
mod caught;
mod changed;
mod fix;
mod judge;
mod load;
mod measure;
mod open;
mod outcome;
mod run;
mod settle;
mod sight;
mod summary;

pub use crate::eval::settings::DEFAULT_SAMPLES;
pub use catalogue::rule_infos;
pub use fix::{Fixed, fixable, lint_and_fix};
pub use open::open_base;
pub use outcome::{Error, holds_asset};
pub use run::{lint, lint_trees};
