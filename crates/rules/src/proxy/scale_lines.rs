//! Scale lines that cannot be read, or are missing beside others.

use super::super::Rule;
use super::{AXES, INDEX, Text, VALUE};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_formats::mhclo::FaultKind;
use mhlint_formats::python_float;
use std::cmp::Ordering;

pub(super) fn unreadable(rule: &Rule, text: &Text<'_, '_>) -> Option<Finding> {
    let short = text
        .reading
        .faults(|kind| kind == FaultKind::ShortScale)
        .and_then(|(faults, _)| faults.first().copied());
    let word = text
        .reading
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
    let is_there = |axis: &&&str| text.reading.last(axis).is_some();
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
            text.reading.last(written)?.line,
            format!("`{lacking}` is missing beside `{written}`"),
        ),
    };
    let finding = rule
        .at(text.file, Place::Line(line), message)
        .key(*lacking)
        .case(SCALE_ALONE);
    Some(finding.help("write a line for each of the three axes, or for none"))
}

const SCALE_ALONE: Case = &[(
    Makehuman1,
    Level::Error,
    "does not put the asset on: `TypeError` when it is fitted",
)];
const NOWHERE: Case = &[(
    Makehuman1,
    Level::Warning,
    "divides by 0: all vertices of the asset have no position (NaN)",
)];
const MIRRORED: Case = &[(
    Makehuman1,
    Level::Warning,
    "mirrors all offsets along the axis",
)];

/// What is wrong with the distance of a scale, by which it divides as it is written.
pub(super) fn distance(text: &Text<'_, '_>, name: &str, distance: f32) -> Option<(String, Case)> {
    match distance
        .partial_cmp(&0.0)
        .filter(|_| text.is_makehuman1())?
    {
        Ordering::Equal => Some((format!("the distance of `{name}` is 0"), NOWHERE)),
        Ordering::Less => Some((
            format!("the distance of `{name}` is {distance}, which is negative"),
            MIRRORED,
        )),
        Ordering::Greater => None,
    }
}
