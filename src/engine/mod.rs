//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod catalogue;
mod changed;
mod compose;
mod data;
pub mod evaluate;
mod gauge;
mod input;
mod load;
mod locate;
mod loose;
mod measure;
mod outcome;
mod read;
mod references;
mod run;
mod select;
mod stack;

pub use catalogue::rule_infos;
pub use outcome::{Error, Outcome, RootSummary, Summary, Timing};
pub use run::{Options, lint, lint_trees};
