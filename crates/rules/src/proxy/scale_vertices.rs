//! The two vertices of a scale line on the base mesh, and how far apart they are.

use super::super::Rule;
use super::super::units::length;
use super::{AXES, INDEX, Text, USUAL_SHARE, apart};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, Place,
};
use mhlint_formats::mhclo::Scale;
use mhlint_repo::Body;

const FLAT: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "scales by 0: all offsets along the axis vanish",
    ),
    (
        Makehuman1,
        Level::Warning,
        "scales by 0: all offsets along the axis vanish",
    ),
];
const OTHER: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "scales all offsets along the axis by a wrong factor",
    ),
    (
        Makehuman1,
        Level::Warning,
        "scales all offsets along the axis by a wrong factor",
    ),
];
const FROM_END: Case = &[
    (
        Makehuman2,
        Level::Warning,
        "counts from the end and scales by another distance",
    ),
    (
        Makehuman1,
        Level::Warning,
        "counts from the end and scales by another distance",
    ),
];

/// Two vertices of a scale that are nearer than this along its axis do not differ.
const NOTHING: f32 = 0.001;

/// What to do about a distance.
pub(super) const MEASURE: &str = "write the distance that the two vertices have along the axis";

pub(super) fn finding(
    rule: &Rule,
    body: &Body<'_>,
    text: &Text<'_, '_>,
    axis: usize,
    scale: &Scale,
) -> Option<Finding> {
    let name = AXES.get(axis)?;
    let told = |message: String| {
        rule.at(text.file, Place::Line(scale.line), message)
            .key(*name)
    };
    let size = text.size_of_base(body)?;
    // That it is of another base mesh is reported for its rows.
    if text.is_foreign(body) {
        return None;
    }
    let names =
        "name two vertices of the base mesh that are far apart along the axis, with their distance";
    let end = i64::try_from(size.with_seams).unwrap_or(i64::MAX);
    let is_outside = |vertex: &i64| *vertex >= end || *vertex < -end;
    if let Some(vertex) = scale.vertices.into_iter().find(is_outside) {
        let last = size.vertices.saturating_sub(1);
        let message =
            format!("vertex {vertex} of `{name}` does not exist; the base mesh has 0 to {last}");
        return (!text.reaches_beyond(body)).then(|| told(message).case(INDEX).help(names));
    }
    if let Some(vertex) = scale.vertices.into_iter().find(|vertex| *vertex < 0) {
        return Some(
            told(format!("vertex {vertex} of `{name}` is negative"))
                .case(FROM_END)
                .help(names),
        );
    }
    let distance = apart(body, axis, scale)?;
    let [a, b] = scale.vertices;
    if a != b && distance >= NOTHING {
        let message = format!(
            "`{name}` says {}, but its vertices are {} apart",
            length(scale.distance),
            length(distance)
        );
        let help = text.use_with_its_base(MEASURE);
        let is_usual = USUAL_SHARE.contains(&(distance / scale.distance));
        return (!is_usual).then(|| told(message).case(OTHER).help(help));
    }
    let message = if a == b {
        format!("`{name}` names vertex {a} twice")
    } else {
        format!("vertices {a} and {b} of `{name}` have the same coordinate on that axis")
    };
    Some(told(message).case(FLAT).help(names))
}
