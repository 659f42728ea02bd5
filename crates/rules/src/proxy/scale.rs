//! Offsets are scaled by three distances on the base mesh.

use std::cmp::Reverse;

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::{AXES, Text, blender, scale_lines, scale_vertices, shear, texts};
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

/// Below this the loader turns scaling off.
const SMALLEST: f32 = 0.01;

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return blender::scale::faults(&RULE, body, out);
    }
    for text in texts(body) {
        out.extend(scale_lines::unreadable(&RULE, &text));
        out.extend(shear::finding(&RULE, body, &text));
        // Topologies are scaled by MakeHuman 1 alone.
        if text.reading.stops() || text.worn.is_topology() && !text.is_makehuman1() {
            continue;
        }
        // Without offsets there is nothing to scale, but what stops the loader stops it, and what
        // is not a number stays so.
        let has_offsets = text.clothes.rows.has_offsets;
        let is_felt = |scale: &Scale, finding: &Finding| {
            let leaves_nan = scale.distance == 0.0 || scale.distance.is_nan();
            has_offsets || leaves_nan && text.is_makehuman1() || finding.level == Level::Error
        };
        let scales = text
            .clothes
            .scales
            .iter()
            .enumerate()
            .filter_map(|(axis, scale)| Some((axis, scale.as_ref()?)));
        let faults = scales.filter_map(|(axis, scale)| {
            fault(body, &text, axis, scale).filter(|finding| is_felt(scale, finding))
        });
        out.extend(worst(faults.collect()));
        out.extend(
            scale_lines::missing(&RULE, &text).filter(|_| has_offsets || text.is_makehuman1()),
        );
    }
}

/// Lines that were exchanged, or written in another unit, have one cause: the worst is told.
fn worst(mut faults: Vec<Finding>) -> Option<Finding> {
    faults.sort_by_key(|finding| Reverse(finding.level));
    let more = faults.len().saturating_sub(1);
    let mut worst = faults.into_iter().next()?;
    if more > 0 {
        worst.message = format!(
            "{} ({more} more of the scale lines at fault)",
            worst.message
        );
    }
    Some(worst)
}

fn fault(body: &Body<'_>, text: &Text<'_, '_>, axis: usize, scale: &Scale) -> Option<Finding> {
    let name = AXES.get(axis)?;
    let told = |message: String| {
        RULE.at(text.file, Place::Line(scale.line), message)
            .key(*name)
    };
    let help = scale_vertices::MEASURE;
    if scale.distance.is_nan() {
        return Some(
            told(format!("the distance of `{name}` is not a number"))
                .case(LOST)
                .help(help),
        );
    }
    if let Some((message, case)) = scale_lines::distance(text, name, scale.distance) {
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
    scale_vertices::finding(&RULE, body, text, axis, scale)
}
