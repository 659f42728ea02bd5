//! No vertex hangs on more bones than engines take.

use super::super::{Check, Rule, RuleCx};
use super::places::{self, Worst};
use crate::diag::{Application::Makehuman2, Element, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::rig_measure::ENGINE_INFLUENCES;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "uses all bones, but its glTF export keeps only the four largest weights: the exported surface bends \
         differently",
    )],
    docs: "A vertex has weights of more than four bones.\n\n\
        MakeHuman 2 itself has no limit. Its glTF export, like most engines, keeps the four largest weights of a \
        vertex and scales them to a sum of 1. The finding counts these vertices and names the one that loses the \
        largest share, one of the visible body before one of a helper.\n\n\
        Small lost shares are harmless; otherwise paint the vertices with fewer bones.",
    ..RuleInfo::new("weights-too-many-influences", Level::Info, "a vertex has weights of more than four bones")
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else { return };
    let Some(Worst { vertex, value: share, places }) = places::worst(body, &weights.over, |share| share) else {
        return;
    };
    let vertices = body.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let have = match &places {
        _ if weights.over.len() == 1 => "has".to_owned(),
        Some(places) => format!("({places}) have"),
        None => "have".to_owned(),
    };
    let message = format!(
        "{} of {vertices} vertices {have} weights of more than {ENGINE_INFLUENCES} bones (up to {}); with only \
         {ENGINE_INFLUENCES}, {} loses {:.1} % of its weight",
        weights.over.len(),
        weights.most,
        body.vertex(vertex),
        share * 100.0
    );
    let place = Place::Element(Element { kind: "vertex", index: u64::from(vertex) });
    let evidence = Evidence::counted(weights.over.len()).out_of(vertices);
    out.push(
        RULE.at(file, place, message)
            .parts(weights.over.iter().map(|(vertex, _)| vertex))
            .help("for export, paint the vertices that lose much with fewer bones; MakeHuman itself has no limit")
            .evidence(evidence.with_worst(f64::from(share), format!("vertex {vertex}"))),
    );
}
