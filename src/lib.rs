//! Judges and evaluates asset repositories of the `MakeHuman` family.
//!
//! One way through the house: discover → source → formats → repo → rules → engine → report → cli.

pub mod cli;
pub mod diag;
pub mod discover;
pub mod engine;
pub mod eval;
pub mod formats;
pub mod json;
pub mod repo;
pub mod report;
mod rules;
pub mod source;

pub use diag::{Application, Finding, Level};
pub use engine::{Error, Options, Outcome, lint, lint_trees};
pub use source::Tree;
