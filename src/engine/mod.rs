//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod baseline;
mod catalogue;
mod caught;
mod changed;
mod compose;
pub mod evaluate;
mod gauge;
mod heard;
mod idle;
mod judge;
mod known;
mod load;
mod locate;
mod measure;
mod mend;
mod mute;
mod outcome;
mod parts;
mod references;
mod run;
mod scope;
mod select;
mod sight;

pub use crate::eval::settings::DEFAULT_SAMPLES;
pub use baseline::{Baseline, Entry};
pub use catalogue::{is_upkeep, rule_infos};
pub use mend::{Mended, mend, mendable};
pub use outcome::{Error, Outcome, RootSummary, Summary, TakenOver, Timing};
pub use run::{lint, lint_trees};
