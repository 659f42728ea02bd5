//! What is said of fields that are no numbers, whoever says it.

use super::super::Rule;
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::target::{MARKERS, TargetFacts, UnreadableField};
use mhlint_repo::FileFacts;

/// The finding on the unreadable fields of a target, if there are any.
pub(super) fn finding(rule: &Rule, file: &FileFacts, facts: &TargetFacts) -> Option<Finding> {
    let first = facts.unreadable.first()?;
    let rows = facts.unreadable_rows;
    let is_marker = |field: &UnreadableField| MARKERS.contains(&field.field.as_str());
    let are_markers = facts.unreadable.iter().all(is_marker);
    let conflict = facts
        .conflict
        .as_ref()
        .map(|(_, marker)| marker)
        .filter(|_| are_markers);
    let message = if let Some(marker) = conflict {
        format!("unresolved merge conflict: `{marker}`")
    } else if rows == 1 {
        format!("`{}` is not a number", first.field)
    } else {
        format!("`{}` is not a number ({rows} such rows)", first.field)
    };
    let place = Place::Span(first.start..first.start + first.field.len());
    let mut evidence = Evidence::of_unnamed(
        facts
            .unreadable
            .iter()
            .map(|field| format!("line {}", field.line)),
    );
    evidence.count = rows;
    let finding = rule
        .at(file, place, message)
        .parts(facts.unreadable_names.names())
        .evidence(evidence.out_of(facts.rows));
    if conflict.is_some() {
        return Some(
            finding.help("keep one side, and remove the lines `<<<<<<<`, `=======` and `>>>>>>>`"),
        );
    }
    Some(
        finding.help(
            "write the row as `INDEX X Y Z`: an integer and three decimal numbers with a point",
        ),
    )
}
