//! The tool's own inputs: mutes and settings that do not do what they were written for.

pub(super) mod baseline_stale;
pub(super) mod expired_ignore;
pub(super) mod missing_reason;
pub(super) mod unknown_rule;
pub(super) mod unused_glob;
pub(super) mod unused_ignore;

use super::Rule;
use crate::diag::{Finding, Mute};

/// What to do about something that is not found any more, while there are errors.
const MEND_FIRST: &str = "mend the errors first: what they hide may still be there";

/// A finding of `rule` on a mute.
fn on(rule: &Rule, mute: &Mute, message: String) -> Finding {
    let covers = mute.covers.as_deref().unwrap_or_default();
    let finding = Finding::new(&rule.info, mute.path.clone(), mute.place.clone(), message);
    finding.key(format!("{} {covers}", mute.rule).trim_end())
}

/// ` in PATH` for a mute that names its files.
fn where_of(mute: &Mute) -> String {
    mute.covers.as_ref().map_or_else(|| " in this file".to_owned(), |covers| format!(" in `{covers}`"))
}
