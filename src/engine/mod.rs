//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod baseline;
mod catalogue;
mod caught;
mod changed;
mod heard;
mod idle;
mod judge;
mod known;
mod load;
mod locate;
mod measure;
mod mend;
mod mute;
mod open;
mod outcome;
mod parts;
mod run;
mod scope;
mod select;
mod sight;
mod summary;

pub use crate::eval::settings::DEFAULT_SAMPLES;
pub use catalogue::rule_infos;
pub use mend::{Mended, mend, mendable};
pub use open::open_base;
pub use outcome::{Error, holds_asset};
pub use run::{lint, lint_trees};
