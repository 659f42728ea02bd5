//! Patterns in models that no slider has.

use std::collections::BTreeSet;

use super::super::{Rule, RuleCx, did_you_mean};
use super::known_pattern::Known;
use super::own;
use mhlint_diag::{EXAMPLES, Evidence, Finding, Level, Place, grouped};
use mhlint_formats::mhm::Modifier;
use mhlint_repo::makehuman2::{Base, SavedModel, View};

/// A modifier, with the model that sets it.
type Line<'v> = (&'v SavedModel<'v>, &'v Modifier);

/// Findings on patterns that no slider has. Patterns that the same models set are one finding.
pub(super) fn unknown(
    rule: &Rule,
    view: &View<'_>,
    base: &Base<'_>,
    cx: &RuleCx<'_>,
) -> Vec<Finding> {
    let known = Known::of(view, base);
    // A pattern that a component of the macros names is reported there.
    let macros = base
        .macro_file()
        .into_iter()
        .flat_map(|(_, file)| &file.components);
    let told: BTreeSet<&str> = macros
        .filter_map(|component| component.pattern.as_deref())
        .collect();
    let is_lost = |(_, one): &Line<'_>| known.lacks(one) && !told.contains(&*one.pattern.text);
    let lines =
        own(view, base).flat_map(|saved| saved.model.modifiers.iter().map(move |one| (saved, one)));
    let by_pattern = grouped(
        lines
            .filter(is_lost)
            .map(|line| (&*line.1.pattern.text, line)),
    );
    let models = |lines: &[Line<'_>]| {
        lines
            .iter()
            .map(|(saved, _)| saved.file.path.clone())
            .collect::<Vec<_>>()
    };
    let by_models = grouped(
        by_pattern
            .into_values()
            .map(|lines| (models(&lines), lines)),
    );
    let told = by_models
        .into_values()
        .filter_map(|patterns| unknown_in(rule, base, &patterns, cx));
    told.collect()
}

fn unknown_in(
    rule: &Rule,
    base: &Base<'_>,
    patterns: &[Vec<Line<'_>>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let lines = patterns.first()?;
    let (saved, first) = lines.first()?;
    let models = if lines.len() > 1 {
        format!(" ({} models)", lines.len())
    } else {
        String::new()
    };
    let message = match patterns.len() {
        1 => format!("no slider has the pattern `{}`{models}", first.pattern.text),
        count => format!(
            "no slider has the pattern of {count} modifiers, first `{}`{models}",
            first.pattern.text
        ),
    };
    let known = base
        .sliders
        .iter()
        .flat_map(|slider| slider.pattern.names());
    let near = cx
        .suggestions
        .nearest(&first.pattern.text, known.map(String::as_str));
    let place = |one: &Modifier| Place::Span(one.pattern.span.clone());
    let mut finding = rule
        .at(saved.file, place(first), message)
        .key("unknown")
        .level(Level::Warning);
    for (other, one) in lines.iter().skip(1).take(EXAMPLES - 1) {
        finding = finding.related(other.file.path.clone(), place(one), "also here");
    }
    let all = patterns
        .iter()
        .flatten()
        .map(|(saved, one)| (&*one.pattern.text, &saved.file.path, place(one)));
    let texts = patterns
        .iter()
        .flatten()
        .map(|(_, one)| one.pattern.text.to_string());
    let finding = finding.parts_at(all).evidence(Evidence::of_cases(texts));
    let help = did_you_mean(
        near,
        "write the pattern of a slider, or check the model together with the pack that has it",
    );
    Some(
        finding
            .effect("lists it as missing and does not apply it")
            .help(help),
    )
}
