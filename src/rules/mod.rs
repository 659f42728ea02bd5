//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod macros;
mod rule;
mod target;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[&macros::steps_length::RULE, &target::syntax::RULE];
