//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod catalogue;
mod caught;
mod changed;
mod compose;
pub mod evaluate;
mod fix;
mod gauge;
mod judge;
mod load;
mod measure;
mod outcome;
mod references;
mod run;
mod settle;
mod sight;

pub use crate::eval::settings::DEFAULT_SAMPLES;
pub use catalogue::{is_upkeep, rule_infos};
pub use fix::{Fixed, fixable, lint_and_fix};
pub use outcome::{Error, Outcome, RootSummary, Summary, TakenOver, Timing};
pub use run::{lint, lint_trees};
pub use settle::{Baseline, Entry};
