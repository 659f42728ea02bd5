//! No vertex hangs on more bones than engines take.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Element, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::rig_measure::ENGINE_INFLUENCES;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "uses all of them, but its glTF export keeps the four largest: there the surface bends otherwise",
        )],
        docs: "Vertices that more than four bones move.\n\nMakeHuman 2 itself has no limit. Its glTF export, like most engines, \
            keeps the four largest weights of a vertex and scales them to 1. The finding says how many vertices that concerns \
            and where the largest share is lost.\n\nHarmless where the lost shares are small; otherwise paint with fewer bones.",
        ..RuleInfo::new("weights-too-many-influences", Level::Info, "more than four bones on a vertex")
    },
    check: Check::Numeric(run),
};

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((weights, file)) = measures.weights.as_ref().zip(body.default_weights()) else { return };
    let Some((vertex, share)) = weights.worst_reduction.filter(|_| !weights.over.is_empty()) else { return };
    let vertices = body.mesh.map_or(0, |(_, mesh)| mesh.positions.len());
    let message = format!(
        "{} of {vertices} vertices are moved by more than {ENGINE_INFLUENCES} bones (up to {}); cut to {ENGINE_INFLUENCES}, \
         vertex {vertex} loses {:.1} % of its weight",
        weights.over.len(),
        weights.most,
        share * 100.0
    );
    let place = Place::Element(Element { kind: "vertex", index: u64::from(vertex) });
    let evidence = Evidence::counted(weights.over.len()).out_of(vertices);
    out.push(
        RULE.at(file, place, message)
            .parts(&weights.over)
            .help("fine inside MakeHuman; for engines paint with fewer bones where much is lost")
            .evidence(evidence.with_worst(f64::from(share), format!("vertex {vertex}"))),
    );
}
