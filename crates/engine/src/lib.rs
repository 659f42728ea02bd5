//! The order of things: read all files in parallel, connect layers, run rules, place and sort
//! findings.
//!
//! Has the threads, as `evaluate` has some. Prints nothing and checks nothing.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod catalogue;
mod caught;
mod check;
mod consumers;
mod coverage;
mod covered;
mod error;
mod fix;
mod load;
mod measure;
mod replaced;
mod run;
mod settle;
mod summary;
mod verdict;

pub use catalogue::rule_infos;
pub use covered::{CoveredKind, covered_kinds};
pub use error::{BaselineFault, Error, PathFault, SelectorFault};
pub use fix::{Fixed, lint_and_fix};
pub use load::{Proposal, open_base, propose};
pub use replaced::lint_with_replacements;
pub use run::{lint, lint_trees, lint_trees_beside};

pub use fix::fixable;
pub use load::is_pack;
pub use mhlint_eval::settings::DEFAULT_SAMPLES;
pub use verdict::holds_asset;
