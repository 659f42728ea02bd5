//! Rules on the text and the shape of any JSON.

mod duplicate_key;
mod schema;
mod schema_help;
mod schema_words;
mod syntax;
mod told_keys;
mod too_deep;
mod unknown_key;

use super::{Rule, counted};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_repo::FileFacts;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &duplicate_key::RULE,
    &schema::RULE,
    &syntax::RULE,
    &too_deep::RULE,
    &unknown_key::RULE,
];

/// Says of a file with more faults than are kept how many of them the other findings do not list;
/// `what` names one.
fn left_out(rule: &Rule, file: &FileFacts, count: usize, what: &str) -> Option<Finding> {
    let message = format!("{} not listed", counted(count, &format!("more {what}")));
    let help = "fix the listed ones, then run mhlint again";
    let finding = rule
        .at(file, Place::File, message)
        .key("not listed")
        .help(help);
    (count > 0).then(|| finding.evidence(Evidence::counted(count)))
}
