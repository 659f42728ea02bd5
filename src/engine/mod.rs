//! The order of things: read all files in parallel, connect layers, run rules, place and sort findings.
//!
//! The only place with threads. Prints nothing and judges nothing.

mod catalogue;
mod compose;
mod data;
pub mod evaluate;
mod gauge;
mod input;
mod load;
mod locate;
mod measure;
mod mend;
mod outcome;
mod read;
mod run;
mod select;
mod stack;

pub use catalogue::rule_infos;
pub use mend::{Mended, mend, mendable};
pub use outcome::{Error, Outcome, RootSummary, Summary, Timing};
pub use run::{Options, lint, lint_trees};
