//! Scale lines that cannot be read, or are missing beside others.

use super::super::Rule;
use super::{AXES, INDEX, Text, VALUE, older};
use mhlint_diag::{Finding, Place};
use mhlint_formats::mhclo::FaultKind;
use mhlint_formats::python_float;

pub(super) fn unreadable(rule: &Rule, text: &Text<'_, '_>) -> Option<Finding> {
    let short = text
        .faults(|kind| kind == FaultKind::ShortScale)
        .and_then(|(faults, _)| faults.first().copied());
    let word = text
        .faults(|kind| kind == FaultKind::ScaleWord)
        .and_then(|(faults, _)| faults.first().copied());
    let finding = match (short, word) {
        (Some(fault), _) => {
            let message = format!("`{}` needs two vertices and a distance", fault.word);
            rule.at(text.file, Place::Span(fault.span.clone()), message)
                .key(&*fault.word)
                .case(INDEX)
        }
        (None, Some(fault)) => {
            let kind = if python_float(fault.word.as_bytes()).is_some() {
                "whole number"
            } else {
                "number"
            };
            let message = format!("`{}` in a scale is not a {kind}", fault.word);
            rule.at(text.file, Place::Span(fault.span.clone()), message)
                .key("word")
                .case(VALUE)
        }
        (None, None) => return None,
    };
    Some(finding.help("write two vertices of the base mesh and a distance with a decimal point"))
}

/// Some axes have a line and others have none.
pub(super) fn missing(rule: &Rule, text: &Text<'_, '_>) -> Option<Finding> {
    let is_there = |axis: &&&str| text.last(axis).is_some();
    let written = AXES.iter().find(is_there)?;
    let lacking = AXES.iter().find(|axis| !is_there(axis))?;
    if text.misspelt(lacking).is_some() || text.has_hidden(lacking) {
        return None;
    }
    let empty = text
        .clothes
        .entries
        .iter()
        .find(|entry| &*entry.keyword == *lacking && !entry.is_comment);
    let (line, message) = match empty {
        Some(entry) => (entry.line, format!("`{lacking}` has no values")),
        None => (
            text.last(written)?.line,
            format!("`{lacking}` is missing beside `{written}`"),
        ),
    };
    let finding = rule
        .at(text.file, Place::Line(line), message)
        .key(*lacking)
        .case(older::SCALE_ALONE);
    Some(finding.help("write a line for each of the three axes, or for none"))
}
