//! Sliders that a model sets more than once.

use std::collections::BTreeMap;

use super::super::{Rule, such};
use mhlint_diag::{Evidence, Finding, Level, Place};
use mhlint_formats::mhm::Modifier;
use mhlint_repo::makehuman2::SavedModel;

/// A finding on a pattern that stands in two lines with different values.
pub(super) fn repeated(rule: &Rule, saved: &SavedModel<'_>) -> Option<Finding> {
    let mut known: BTreeMap<&str, &Modifier> = BTreeMap::new();
    let mut lost = Vec::new();
    for one in saved
        .model
        .modifiers
        .iter()
        .filter(|one| !one.pattern.text.is_empty())
    {
        let Some(earlier) = known.insert(&one.pattern.text, one) else {
            continue;
        };
        if let (Ok(before), Ok(now)) = (&earlier.value, &one.value)
            && (before - now).abs() > 0.0
        {
            lost.push((earlier, one));
        }
    }
    let (first, other) = lost.first()?;
    let message = format!(
        "`{}` is set more than once{}",
        first.pattern.text,
        such(lost.len(), "lines")
    );
    let finding = rule
        .at(saved.file, Place::Span(other.pattern.span.clone()), message)
        .key("repeated");
    let finding = finding.related(
        saved.file.path.clone(),
        Place::Span(first.pattern.span.clone()),
        "set here before",
    );
    let finding = finding
        .evidence(Evidence::of_cases(
            lost.iter().map(|(one, _)| one.pattern.text.to_string()),
        ))
        .level(Level::Warning);
    Some(
        finding
            .effect("uses the last value")
            .help("remove the lines that do not count"),
    )
}
