//! Weights must be for vertices that exist.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied};
use crate::diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use crate::repo::Body;

const USUAL: &str = "crashes with `IndexError` while loading the weights";

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, USUAL), (Makehuman1, USUAL), (Mpfb, "silently drops the entry")],
    levels: &[(Mpfb, Level::Warning)],
    docs: "A weights file has an entry for a vertex that the base mesh does not have. Vertices are counted from 0, \
        without UV-seam duplicates.\n\n\
        MakeHuman 2 crashes with `IndexError` while loading the base mesh if an index is too large, and with \
        `OverflowError` if it is negative.\n\n\
        Usually the weights were made for another mesh. Use the weights for this mesh.",
    counts: "entries",
    ..RuleInfo::new("weights-vertex-out-of-range", Level::Error, "weights for a vertex that the mesh does not have")
});

const NEGATIVE: Case = &[(Makehuman2, Level::Error, "crashes with `OverflowError` while loading the weights")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.has_foreign_mesh {
        return;
    }
    for Tallied { own, weights, tally, bone, vertex, place, .. } in tallied(body, |facts| &facts.out_of_range) {
        let vertices = weights.facts.vertices;
        let size = match vertices.checked_sub(1) {
            Some(last) => format!("; the mesh has vertices 0 to {last}"),
            None => String::new(),
        };
        let message = match tally.count {
            1 => format!("bone `{bone}` has a weight for {vertex}, which does not exist{size}"),
            count => {
                format!("{count} entries name vertices that do not exist, first {vertex} in bone `{bone}`{size}")
            }
        };
        let mut finding = RULE
            .at(own.file, place, message)
            .help("use vertices of the base mesh, counted from 0, or the weights that were made for this mesh")
            .evidence(tally.evidence(weights.facts.pairs));
        if weights.facts.negative_index == tally.count {
            finding = finding.case(NEGATIVE);
        }
        out.push(finding);
    }
}
