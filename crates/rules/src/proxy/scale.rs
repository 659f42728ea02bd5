//! Offsets are scaled by three distances on the base mesh.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{AXES, INDEX, Text, USUAL_SHARE, apart, blender, older, scale_lines, shear, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhclo::Scale;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "does not scale the offsets: the asset is too far from small figures and \
            cuts into large ones",
        ),
        (
            Makehuman1,
            "scales the offsets along the axis by another number than written",
        ),
        (
            Mpfb,
            "scales the offsets along the axis by another number than written",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("scale.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-scale",
        Level::Warning,
        "a scale that is not applied as written",
    )
});

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
const LOST: Case = &[
    (
        Makehuman2,
        Level::Error,
        "loses all vertices; the glTF export of the figure crashes with `ValueError`",
    ),
    (
        Makehuman1,
        Level::Warning,
        "leaves all vertices without a position (NaN)",
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

/// Below this the loader turns scaling off.
const SMALLEST: f32 = 0.01;
/// Two vertices of a scale that are nearer than this along its axis do not differ.
const NOTHING: f32 = 0.001;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::scale::faults(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(scale_lines::unreadable(&RULE, &text));
        out.extend(shear::finding(&RULE, body, &text));
        // Topologies are scaled by MakeHuman 1 alone.
        if text.stops() || text.worn.is_topology() && !text.is_makehuman1() {
            continue;
        }
        // Without offsets there is nothing to scale, but what stops the loader stops it, and what
        // is not a number stays so.
        let has_offsets = text.clothes.rows.has_offsets;
        let needs_offsets = |scale: &Scale| {
            !text.is_makehuman1() || scale.distance != 0.0 && !scale.distance.is_nan()
        };
        let scales = text
            .clothes
            .scales
            .iter()
            .enumerate()
            .filter_map(|(axis, scale)| Some((axis, scale.as_ref()?)));
        let faults = scales.filter_map(|(axis, scale)| {
            Some((needs_offsets(scale), fault(body, &text, axis, scale)?))
        });
        // Lines that were exchanged, or written in another unit, have one cause: the worst is told.
        let is_felt = |(needs, finding): &(bool, Finding)| {
            has_offsets || !needs || finding.level == Level::Error
        };
        let mut own: Vec<Finding> = faults.filter(is_felt).map(|(_, finding)| finding).collect();
        own.sort_by_key(|finding| std::cmp::Reverse(finding.level));
        let more = own.len().saturating_sub(1);
        out.extend(own.into_iter().next().map(|mut first| {
            if more > 0 {
                first.message = format!(
                    "{} ({more} more of the scale lines at fault)",
                    first.message
                );
            }
            first
        }));
        out.extend(
            scale_lines::missing(&RULE, &text).filter(|_| has_offsets || text.is_makehuman1()),
        );
    }
}

fn fault(body: &Body<'_>, text: &Text<'_, '_>, axis: usize, scale: &Scale) -> Option<Finding> {
    let name = AXES.get(axis)?;
    let told = |message: String| {
        RULE.at(text.file, Place::Line(scale.line), message)
            .key(*name)
    };
    let [a, b] = scale.vertices;
    let help = "write the distance that the two vertices have along the axis";
    if scale.distance.is_nan() {
        return Some(
            told(format!("the distance of `{name}` is not a number"))
                .case(LOST)
                .help(help),
        );
    }
    if let Some((message, case)) = older::distance(text, name, scale.distance) {
        return Some(told(message).case(case).help(help));
    }
    if scale.distance < SMALLEST && !text.is_makehuman1() {
        return Some(
            told(format!(
                "the distance of `{name}` is {}, below {}",
                length(scale.distance),
                length(SMALLEST)
            ))
            .help(help),
        );
    }
    let size = text.size_of_base(body)?;
    let last = size.vertices.saturating_sub(1);
    let names =
        "name two vertices of the base mesh that are far apart along the axis, with their distance";
    let end = i64::try_from(size.with_seams).unwrap_or(i64::MAX);
    // That it is of another base mesh is reported for its rows.
    if text.is_foreign(body) {
        return None;
    }
    let outside = |vertex: i64| vertex >= end || vertex < -end;
    if let Some(vertex) = [a, b].into_iter().find(|vertex| outside(*vertex)) {
        let message =
            format!("vertex {vertex} of `{name}` does not exist; the base mesh has 0 to {last}");
        return (!text.reaches_beyond(body)).then(|| told(message).case(INDEX).help(names));
    }
    if let Some(vertex) = [a, b].into_iter().find(|vertex| *vertex < 0) {
        return Some(
            told(format!("vertex {vertex} of `{name}` is negative"))
                .case(FROM_END)
                .help(names),
        );
    }
    let distance = apart(body, axis, scale)?;
    let share = distance / scale.distance;
    if a != b && distance >= NOTHING {
        let message = format!(
            "`{name}` says {}, but its vertices are {} apart",
            length(scale.distance),
            length(distance)
        );
        let help = text.use_with_its_base(help);
        return (!USUAL_SHARE.contains(&share)).then(|| told(message).case(OTHER).help(help));
    }
    let message = if a == b {
        format!("`{name}` names vertex {a} twice")
    } else {
        format!("vertices {a} and {b} of `{name}` have the same coordinate on that axis")
    };
    Some(told(message).case(FLAT).help(names))
}
