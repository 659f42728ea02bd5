//! What is said of fields that are no numbers, whoever says it.

use super::super::Rule;
use crate::diag::{Evidence, Finding, Place};
use crate::formats::target::TargetFacts;
use crate::repo::FileFacts;

/// The finding on the unreadable fields of a target, if there are any.
pub(super) fn finding(rule: &Rule, file: &FileFacts, facts: &TargetFacts) -> Option<Finding> {
    let first = facts.unreadable.first()?;
    let rows = facts.unreadable_rows;
    let message = if rows == 1 {
        format!("`{}` is no number", first.field)
    } else {
        format!("`{}` is no number ({rows} rows like it)", first.field)
    };
    let place = Place::Span(first.start..first.start + first.field.len());
    let mut evidence = Evidence::of_unnamed(facts.unreadable.iter().map(|field| format!("line {}", field.line)));
    evidence.count = rows;
    let finding =
        rule.at(file, place, message).parts(facts.unreadable_names.names()).evidence(evidence.out_of(facts.rows));
    Some(finding.help("a row is `INDEX X Y Z`: an integer and three decimals with a point"))
}
