//! The tool's own inputs: ignores and settings that do not do what they were written for.

mod baseline_stale;
mod expired_ignore;
mod missing_reason;
mod unknown_rule;
mod unused_glob;
mod unused_ignore;

use super::Rule;
use mhlint_diag::{Finding, IgnoreUse};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &baseline_stale::RULE,
    &expired_ignore::RULE,
    &missing_reason::RULE,
    &unknown_rule::RULE,
    &unused_glob::RULE,
    &unused_ignore::RULE,
];

/// What to do about something that is not found any more, while there are errors.
const FIX_FIRST: &str = "fix the errors first: they may hide what is not found";

/// A finding of `rule` on an ignore.
fn on(rule: &Rule, ignore: &IgnoreUse, message: String) -> Finding {
    let covers = ignore.covers.as_deref().unwrap_or_default();
    let finding = Finding::new(
        &rule.info,
        ignore.path.clone(),
        ignore.place.clone(),
        message,
    );
    finding.key(format!("{} {covers}", ignore.rule).trim_end())
}

/// What an ignore is called.
fn called(ignore: &IgnoreUse) -> &'static str {
    if ignore.covers.is_some() {
        "`[[ignore]]`"
    } else {
        "ignore comment"
    }
}

/// ` in PATH` for an ignore that names its files.
fn where_of(ignore: &IgnoreUse) -> String {
    ignore.covers.as_ref().map_or_else(
        || " in this file".to_owned(),
        |covers| format!(" in `{covers}`"),
    )
}
