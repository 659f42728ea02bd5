//! What the loader drops is too little to be seen.

use super::super::units::length;
use super::super::{Check, Rule, RuleCx};
use super::loss::{DISTANCE, ID, noticeable_loss};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Element, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "drops weights up to 0.0001, and pulls the vertices towards the origin of \
            the scene in pose mode",
        ),
        (
            Makehuman1,
            "drops weights up to 0.0001, and pulls the vertices towards the origin of the scene \
                in every pose",
        ),
    ],
    docs: include_str!("lost_after_threshold.md").trim_ascii_end(),
    options: &[DISTANCE],
    counts: "vertices",
    grows: Grows::more(MeasureKind::Distance),
    ..RuleInfo::new(
        ID,
        Level::Warning,
        "vertices lose visible weight to the threshold of the \
        loader",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(loss) = noticeable_loss(body, cx) else {
        return;
    };
    let (losing, vertex) = (loss.vertices.len(), loss.vertex);
    let (most, share, pull) = (body.vertex(vertex), loss.share * 100.0, length(loss.pull));
    let message = match losing {
        1 => format!("{most} loses {share:.2} % of its weight and moves {pull} towards the origin"),
        count => format!(
            "{count} vertices lose tiny weights, most {most}: {share:.2} %, which moves it {pull}"
        ),
    };
    let vertices = body.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let evidence = Evidence::counted(losing).out_of(vertices);
    let place = Place::Element(Element {
        kind: "vertex",
        index: u64::from(vertex),
    });
    let finding = RULE
        .at(loss.file, place, message)
        .parts(&loss.vertices)
        .help("remove the tiny weights and normalise the rest")
        .evidence(evidence.with_worst(loss.pull, format!("vertex {vertex}")));
    out.push(if loss.pull < cx.option_of(ID, &DISTANCE) {
        finding.at_most(Level::Info)
    } else {
        finding
    });
}
