//! Weights must be for vertices that exist.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied};
use crate::diag::{Application, Case, Finding, Level, RuleInfo};
use crate::repo::Body;

const USUAL: &str = "stops with an IndexError while the weights are loaded";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, USUAL),
            (Application::Makehuman1, USUAL),
            (Application::Mpfb, "leaves the entry out without a message"),
        ],
        levels: &[(Application::Mpfb, Level::Warning)],
        docs: "The vertices of a weights file are those of the base mesh, counted from 0; duplicates along texture \
            seams do not count.\n\nMakeHuman 2 stops with an IndexError while it loads the base when an index is \
            too large. Negative ones stop it with an OverflowError.\n\nUsually the weights belong to another \
            mesh.",
        ..RuleInfo::new("weights-vertex-out-of-range", Level::Error, "weights for a vertex that the mesh does not have")
    },
    check: Check::Body(run),
};

const NEGATIVE: Case =
    &[(Application::Makehuman2, Level::Error, "stops with an OverflowError while the weights are loaded")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.has_foreign_mesh {
        return;
    }
    for Tallied { own, weights, tally, bone, vertex, place, .. } in tallied(body, |facts| &facts.out_of_range) {
        let vertices = weights.facts.vertices;
        let size = match vertices.checked_sub(1) {
            Some(last) => format!(", but the mesh has vertices 0 to {last}"),
            None => String::new(),
        };
        let message = match tally.count {
            1 => format!("bone `{bone}` weights vertex {vertex}{size}"),
            count => format!(
                "{count} entries weight a vertex that does not exist, the first is vertex {vertex} of bone `{bone}`{size}"
            ),
        };
        let mut finding = RULE
            .at(own.file, place, message)
            .help("use vertices of the base mesh, counted from 0; were the weights made for another mesh?")
            .evidence(tally.evidence(weights.facts.pairs));
        if weights.facts.negative_index == tally.count {
            finding = finding.case(NEGATIVE);
        }
        out.push(finding);
    }
}
