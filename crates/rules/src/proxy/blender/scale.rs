//! The lines of the scale (`docs/loaders/mpfb/clothes.md#fitting`).

use std::cmp::Ordering;

use super::super::scale_vertices::MEASURE;
use super::super::{AXES, Text, USUAL_SHARE, apart, texts};
use super::at;
use crate::Rule;
use crate::units::length;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level};
use mhlint_formats::mhclo::{Scale, StopCause};
use mhlint_repo::Body;

const VALUE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ValueError` when the asset is loaded",
)];
const INDEX: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when the asset is loaded",
)];
const TYPE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `TypeError` when it fits the asset",
)];
const ZERO: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `ZeroDivisionError` when it fits the asset",
)];
const BEYOND: Case = &[(
    Mpfb,
    Level::Error,
    "fails with an exception when it fits the asset",
)];
const MIRRORED: Case = &[(Mpfb, Level::Warning, "mirrors all offsets along the axis")];
const NOWHERE: Case = &[(
    Mpfb,
    Level::Warning,
    "loses all vertices of the asset: they have no position (NaN)",
)];
const FROM_END: Case = &[(
    Mpfb,
    Level::Warning,
    "counts the vertex from the end of the mesh",
)];
const FLAT: Case = &[(Mpfb, Level::Warning, "loses all offsets along the axis")];
const IGNORED: Case = &[(
    Mpfb,
    Level::Warning,
    "ignores the other scale lines: offsets do not follow the size of the body",
)];

pub(in crate::proxy) fn faults(rule: &Rule, body: &Body<'_>, out: &mut Vec<Finding>) {
    for text in texts(body) {
        if let Some(stop) = &text.clothes.flow.stop {
            let (message, case) = match stop.cause {
                StopCause::ShortScale => (
                    format!("`{}` needs two vertices and a distance", stop.word),
                    INDEX,
                ),
                StopCause::ScaleWord => {
                    (format!("`{}` in a scale is not a number", stop.word), VALUE)
                }
                _ => continue,
            };
            let finding = rule
                .at(text.file, at(stop.line), message)
                .key("word")
                .case(case);
            out.push(
                finding.help(
                    "write two vertices of the base mesh and a distance with a decimal point",
                ),
            );
            continue;
        }
        if let Some(finding) = lacking(rule, &text) {
            out.push(finding);
            continue;
        }
        let scales = text
            .clothes
            .scales
            .iter()
            .enumerate()
            .filter_map(|(axis, scale)| Some((axis, scale.as_ref()?)));
        let mut found: Vec<Finding> = scales
            .filter_map(|(axis, scale)| fault(rule, body, &text, axis, scale))
            .collect();
        found.sort_by_key(|finding| std::cmp::Reverse(finding.level));
        out.extend(found.into_iter().next());
    }
}

/// Some axes have a line that is read, and others none.
fn lacking(rule: &Rule, text: &Text<'_, '_>) -> Option<Finding> {
    let lines = AXES.map(|axis| text.clothes.flow.line_of(axis));
    let absent = AXES.iter().zip(lines).find(|(_, line)| line.is_none())?.0;
    let (there, line) = AXES
        .iter()
        .zip(lines)
        .find_map(|(axis, line)| Some((axis, line?)))?;
    let finding = rule
        .at(
            text.file,
            at(line),
            format!("`{absent}` is missing beside `{there}`"),
        )
        .key(*absent);
    let finding = finding.case(if lines.first().is_some_and(Option::is_some) {
        TYPE
    } else {
        IGNORED
    });
    Some(finding.help("write a line for each of the three axes, or for none"))
}

fn fault(
    rule: &Rule,
    body: &Body<'_>,
    text: &Text<'_, '_>,
    axis: usize,
    scale: &Scale,
) -> Option<Finding> {
    let name = AXES.get(axis)?;
    let told = |message: String, case: Case| {
        rule.at(text.file, at(scale.line), message)
            .key(*name)
            .case(case)
    };
    match scale.distance.partial_cmp(&0.0) {
        None => {
            return Some(
                told(format!("the distance of `{name}` is not a number"), NOWHERE).help(MEASURE),
            );
        }
        Some(Ordering::Equal) => {
            return Some(told(format!("the distance of `{name}` is 0"), ZERO).help(MEASURE));
        }
        Some(Ordering::Less) => {
            let message = format!(
                "the distance of `{name}` is {}, which is negative",
                scale.distance
            );
            return Some(told(message, MIRRORED).help(MEASURE));
        }
        Some(Ordering::Greater) => {}
    }
    let size = text.size_of_base(body)?;
    let (count, last) = (
        i64::try_from(size.vertices).unwrap_or(i64::MAX),
        size.vertices.saturating_sub(1),
    );
    let names =
        "name two vertices of the base mesh that are far apart along the axis, with their distance";
    if let Some(vertex) = scale
        .vertices
        .into_iter()
        .find(|vertex| *vertex >= count || *vertex < -count)
    {
        let message =
            format!("vertex {vertex} of `{name}` does not exist; the base mesh has 0 to {last}");
        return Some(told(message, BEYOND).help(names));
    }
    if let Some(vertex) = scale.vertices.into_iter().find(|vertex| *vertex < 0) {
        return Some(
            told(format!("vertex {vertex} of `{name}` is negative"), FROM_END).help(names),
        );
    }
    let [a, b] = scale.vertices;
    if a == b {
        return Some(told(format!("`{name}` names vertex {a} twice"), FLAT).help(names));
    }
    let apart = apart(body, axis, scale)?;
    let message = format!(
        "`{name}` says {}, but its vertices are {} apart",
        length(scale.distance),
        length(apart)
    );
    let is_usual = USUAL_SHARE.contains(&(apart / scale.distance));
    (!is_usual).then(|| {
        rule.at(text.file, at(scale.line), message)
            .key(*name)
            .help(MEASURE)
    })
}
