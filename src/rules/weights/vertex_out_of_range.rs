//! Weights must be for vertices that exist.

use super::super::cause::is_beside_foreign_mesh;
use super::super::{Check, Rule, RuleCx};
use super::{bones_of, pair_place};
use crate::diag::{Application, Case, Finding, Level, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError while the weights are loaded")],
        docs: "The vertices of a weights file are those of the base mesh, counted from 0; duplicates along texture \
            seams do not count.\n\nMakeHuman 2 stops with an IndexError while it loads the base when an index is \
            too large. Negative ones stop it with an OverflowError.\n\nUsually the weights belong to another \
            mesh.",
        ..RuleInfo::new("weights-vertex-out-of-range", Level::Error, "weights for a vertex that the mesh does not have")
    },
    check: Check::File(run),
};

const NEGATIVE: Case =
    &[(Application::Makehuman2, Level::Error, "stops with an OverflowError while the weights are loaded")];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if is_beside_foreign_mesh(view, file) {
        return;
    }
    let Some(weights) = bones_of(file) else { return };
    let tally = &weights.facts.out_of_range;
    let (Some((bone, _, vertex, _)), Some(place)) = (tally.first.first(), pair_place(tally)) else { return };
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
        .at(file, place, message)
        .help("use vertices of the base mesh, counted from 0; were the weights made for another mesh?")
        .evidence(tally.evidence(weights.facts.pairs));
    if weights.facts.negative_index == tally.count {
        finding = finding.case(NEGATIVE);
    }
    out.push(finding);
}
