//! Runs for applications that are not checked for users yet: their rules are tried on examples before they count.
//!
//! For the tests of this crate alone; it may change with any version.

use super::error::Error;
use super::load::Side;
use super::run::lint_sides;
use crate::config::Config;
use crate::diag::{Application, Outcome, RuleInfo};
use crate::rules::RULES;
use crate::source::Tree;

/// As [`super::lint_trees`], for these applications in place of those that are checked.
///
/// # Errors
/// As [`super::lint`].
pub fn lint_trees(
    applications: &[Application],
    trees: Vec<Tree>,
    system: Option<Tree>,
    options: &Config,
) -> Result<Outcome, Error> {
    lint_sides(&Side::of(trees, system), None, options, applications)
}

/// As [`super::rule_infos`], for all applications.
pub fn rule_infos() -> Vec<&'static RuleInfo> {
    RULES.iter().map(|rule| &rule.info).collect()
}
