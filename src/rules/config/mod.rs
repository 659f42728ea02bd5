//! The tool's own inputs: ignores and settings that do not do what they were written for.

pub(super) mod baseline_stale;
pub(super) mod expired_ignore;
pub(super) mod missing_reason;
pub(super) mod unknown_rule;
pub(super) mod unused_glob;
pub(super) mod unused_ignore;

use super::Rule;
use crate::diag::{Finding, IgnoreUse};

/// What to do about something that is not found any more, while there are errors.
const FIX_FIRST: &str = "fix the errors first: they may hide what is not found";

/// A finding of `rule` on an ignore.
fn on(rule: &Rule, ignore: &IgnoreUse, message: String) -> Finding {
    let covers = ignore.covers.as_deref().unwrap_or_default();
    let finding = Finding::new(&rule.info, ignore.path.clone(), ignore.place.clone(), message);
    finding.key(format!("{} {covers}", ignore.rule).trim_end())
}

/// What an ignore is called.
fn called(ignore: &IgnoreUse) -> &'static str {
    if ignore.covers.is_some() { "`[[ignore]]`" } else { "ignore comment" }
}

/// ` in PATH` for an ignore that names its files.
fn where_of(ignore: &IgnoreUse) -> String {
    ignore.covers.as_ref().map_or_else(|| " in this file".to_owned(), |covers| format!(" in `{covers}`"))
}
