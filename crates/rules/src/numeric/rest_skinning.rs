//! Skinning with all bones at rest must give the mesh back.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Element, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::skeleton::PARALLEL_SINE;
use mhlint_eval::survey::SHORTEST_BONE;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "deforms the figure as soon as pose mode is entered, before any pose is loaded",
        ),
        (Makehuman1, "deforms the figure in every pose"),
    ],
    docs: include_str!("rest_skinning.md").trim_ascii_end(),
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        "numeric-rest-skinning",
        Level::Error,
        "skinning in the rest pose changes the mesh",
    )
});

/// How far a vertex may move, decimetres: float32 holds 1e-6 at the size of a figure, a chain of
/// matrices loses a little of it.
const TOLERANCE: f64 = 1e-4;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((vertex, moved)) = measures
        .weights
        .as_ref()
        .and_then(|weights| weights.rest_distance)
    else {
        return;
    };
    // A default character that is NaN or infinite is the cause then, and told as such.
    if measures.space.is_none() {
        return;
    }
    let Some(skeleton) = body
        .default_rig()
        .map(|rig| rig.file)
        .filter(|_| !(moved <= TOLERANCE))
    else {
        return;
    };
    let known = measures
        .skeletons
        .iter()
        .filter(|measure| measure.path == skeleton.path)
        .flat_map(|m| &m.bones);
    let mut known = known.filter(|bone| {
        !(bone.length >= SHORTEST_BONE)
            || bone.plane_sine.is_some_and(|sine| !(sine > PARALLEL_SINE))
    });
    if known.next().is_some() {
        return;
    }
    let how = if moved.is_nan() {
        "is not a number".to_owned()
    } else {
        format!("moves by {}", length(moved))
    };
    let place = Place::Element(Element {
        kind: "vertex",
        index: u64::from(vertex),
    });
    out.push(
        RULE.at(
            skeleton,
            place,
            format!(
                "with all bones at rest, {} {how} after skinning",
                body.vertex(vertex)
            ),
        )
        .key("rest")
        .help("correct the rotation planes of the bones that move this vertex")
        .evidence(Evidence::counted(1).with_worst(moved, format!("vertex {vertex}"))),
    );
}
