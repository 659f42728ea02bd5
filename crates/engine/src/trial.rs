//! Runs for applications that are not checked for users yet, and comparisons of trees in memory:
//! rules are tried on examples before they count.
//!
//! For the tests of this crate alone; it may change with any version.

use std::collections::BTreeMap;

use super::catalogue::CHECKED;
use super::error::Error;
use super::load::Side;
use super::run::lint_sides;
use mhlint_config::{Before, Compare, Config};
use mhlint_diag::{Application, Outcome, RuleInfo};
use mhlint_rules::RULES;
use mhlint_source::Tree;

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
    // Who tries an application asks for it by name.
    let options = Config {
        applications: applications.to_vec(),
        ..options.clone()
    };
    lint_sides(&Side::of(trees, system), None, &options, applications)
}

/// As [`super::lint_trees`], with what is new or worse than in the trees before.
///
/// # Errors
/// As [`super::lint`].
pub fn lint_beside(
    [now, before]: [Vec<Tree>; 2],
    [system, system_before]: [Option<Tree>; 2],
    options: &Config,
) -> Result<Outcome, Error> {
    let [now, before] = [Side::of(now, system), Side::of(before, system_before)];
    let (contents, nothing) = (Before::Contents(BTreeMap::new()), BTreeMap::new());
    let compare = Compare {
        with: "before".to_owned(),
        before: contents,
        now: nothing,
        missing: Vec::new(),
    };
    let options = Config {
        compare: Some(compare),
        ..options.clone()
    };
    lint_sides(&now, Some(&before), &options, &CHECKED)
}

/// As [`super::rule_infos`], for all applications.
pub fn rule_infos() -> Vec<&'static RuleInfo> {
    RULES.iter().map(|rule| &rule.info).collect()
}
