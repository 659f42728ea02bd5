//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod baseline;
mod catalogue;
mod caught;
mod changed;
mod data;
mod heard;
mod idle;
mod input;
mod judge;
mod known;
mod load;
mod locate;
mod loose;
mod measure;
mod mend;
mod mute;
mod open;
mod outcome;
mod parts;
mod read;
mod roots;
mod run;
mod scope;
mod select;
mod sight;
mod stack;

pub use crate::eval::settings::DEFAULT_SAMPLES;
pub use baseline::{Baseline, Entry};
pub use catalogue::{is_upkeep, rule_infos};
pub use mend::{Mended, mend, mendable};
pub use open::open_base;
pub use outcome::{Error, Outcome, RootSummary, Summary, TakenOver, Timing};
pub use run::{lint, lint_trees};
