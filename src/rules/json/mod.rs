//! Rules on the text and the shape of any JSON.

pub(super) mod duplicate_key;
pub(super) mod schema;
mod schema_help;
mod schema_words;
pub(super) mod syntax;
mod told_keys;
pub(super) mod too_deep;
pub(super) mod unknown_key;

use super::{Rule, counted};
use crate::diag::{Evidence, Finding, Place};
use crate::repo::FileFacts;

/// Says of a file with more faults than are kept how many of them the other findings do not list; `what` names one.
fn left_out(rule: &Rule, file: &FileFacts, count: usize, what: &str) -> Option<Finding> {
    let message = format!("{} not listed", counted(count, &format!("more {what}")));
    let help = "fix the listed ones, then run mhlint again";
    let finding = rule.at(file, Place::File, message).key("not listed").help(help);
    (count > 0).then(|| finding.evidence(Evidence::counted(count)))
}
