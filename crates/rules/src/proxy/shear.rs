//! Lines of shear, which MakeHuman 1 alone reads (`docs/loaders/makehuman1/clothes.md#fitting`).

use super::super::Rule;
use super::{AXES, INDEX, Text, VALUE};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level, Place};
use mhlint_formats::mhclo::Entry;
use mhlint_formats::{python_float, python_int};
use mhlint_repo::Body;

const BESIDE_SCALE: Case = &[(
    Makehuman1,
    Level::Warning,
    "uses the scale and ignores the shear",
)];
const NOWHERE: Case = &[(
    Makehuman1,
    Level::Warning,
    "divides by 0: all vertices of the asset have no position (NaN)",
)];
const INCOMPLETE: Case = &[(
    Makehuman1,
    Level::Warning,
    "does not shear the asset as written: all three axes are needed",
)];

/// The sets of lines: of the whole body, its left and its right half.
const SETS: [[&str; 3]; 3] = [
    ["shear_x", "shear_y", "shear_z"],
    ["l_shear_x", "l_shear_y", "l_shear_z"],
    ["r_shear_x", "r_shear_y", "r_shear_z"],
];

/// What is wrong with the lines of shear, the worst of it.
pub(super) fn finding(rule: &Rule, body: &Body<'_>, text: &Text<'_, '_>) -> Option<Finding> {
    if !text.is_makehuman1() {
        return None;
    }
    let written = SETS
        .iter()
        .flatten()
        .filter_map(|keyword| text.reading.last(keyword));
    let unreadable = written
        .clone()
        .find_map(|entry| unreadable(rule, text, entry));
    unreadable
        .or_else(|| {
            written
                .clone()
                .find_map(|entry| outside(rule, body, text, entry))
        })
        .or_else(|| beside_scale(rule, text))
        .or_else(|| written.clone().find_map(|entry| flat(rule, text, entry)))
        .or_else(|| SETS.iter().find_map(|set| incomplete(rule, text, set)))
}

fn told(rule: &Rule, text: &Text<'_, '_>, entry: &Entry, message: String) -> Finding {
    rule.at(text.file, Place::Line(entry.line), message)
        .key("shear")
}

/// Two vertices and two coordinates are needed.
fn unreadable(rule: &Rule, text: &Text<'_, '_>, entry: &Entry) -> Option<Finding> {
    let help = "write two vertices of the base mesh and two coordinates with decimal points";
    let words: Vec<&str> = entry
        .value
        .split(' ')
        .filter(|word| !word.is_empty())
        .collect();
    let wrong = words.iter().enumerate().take(4).find_map(|(at, word)| {
        let is_whole = at < 2;
        let fits = if is_whole {
            python_int(word.as_bytes()).is_some()
        } else {
            python_float(word.as_bytes()).is_some()
        };
        (!fits).then_some((word, if is_whole { "whole number" } else { "number" }))
    });
    if let Some((word, kind)) = wrong {
        let message = format!("`{word}` of `{}` is not a {kind}", entry.keyword);
        return Some(told(rule, text, entry, message).case(VALUE).help(help));
    }
    let message = format!("`{}` needs two vertices and two coordinates", entry.keyword);
    (words.len() < 4).then(|| told(rule, text, entry, message).case(INDEX).help(help))
}

/// Vertices that the base mesh does not have.
fn outside(rule: &Rule, body: &Body<'_>, text: &Text<'_, '_>, entry: &Entry) -> Option<Finding> {
    let size = text
        .size_of_base(body)
        .filter(|_| !text.reaches_beyond(body))?;
    let end = i64::try_from(size.with_seams).ok()?;
    let vertices = entry
        .value
        .split(' ')
        .take(2)
        .filter_map(|word| python_int(word.as_bytes()));
    let vertex = vertices
        .into_iter()
        .find(|vertex| *vertex >= end || *vertex < -end)?;
    let last = size.vertices.saturating_sub(1);
    let message = format!(
        "vertex {vertex} of `{}` does not exist; the base mesh has 0 to {last}",
        entry.keyword
    );
    Some(
        told(rule, text, entry, message)
            .case(INDEX)
            .help("name two vertices of the base mesh"),
    )
}

/// It shears only what has no scale.
fn beside_scale(rule: &Rule, text: &Text<'_, '_>) -> Option<Finding> {
    let entry = SETS
        .iter()
        .flatten()
        .find_map(|keyword| text.reading.last(keyword))?;
    let scale = AXES
        .into_iter()
        .find(|axis| text.reading.last(axis).is_some())?;
    let message = format!("`{}` has no effect together with `{scale}`", entry.keyword);
    Some(
        told(rule, text, entry, message)
            .case(BESIDE_SCALE)
            .help("keep the scale or the shear lines"),
    )
}

/// Two coordinates that are the same.
fn flat(rule: &Rule, text: &Text<'_, '_>, entry: &Entry) -> Option<Finding> {
    let numbers: Vec<f64> = entry
        .value
        .split(' ')
        .skip(2)
        .filter_map(|word| python_float(word.as_bytes()))
        .collect();
    let [one, other, ..] = numbers.as_slice() else {
        return None;
    };
    let message = format!("the two coordinates of `{}` are the same", entry.keyword);
    let is_flat = (one - other).abs() == 0.0;
    is_flat.then(|| {
        told(rule, text, entry, message)
            .case(NOWHERE)
            .help("write the coordinates of the two vertices")
    })
}

fn incomplete(rule: &Rule, text: &Text<'_, '_>, set: &[&str; 3]) -> Option<Finding> {
    let entry = set.iter().find_map(|keyword| text.reading.last(keyword))?;
    let missing = set
        .iter()
        .find(|keyword| text.reading.last(keyword).is_none())?;
    let message = format!("`{missing}` is missing beside `{}`", entry.keyword);
    Some(
        told(rule, text, entry, message)
            .case(INCOMPLETE)
            .help("write a line for each of the three axes, or for none"),
    )
}
