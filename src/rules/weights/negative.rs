//! Weights must not be negative.

use super::super::{Check, Rule, RuleCx};
use super::{bones_of, pair_place, worst};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "drops the share and enlarges the others of the vertex (0.25 taken away: a third more); where the sum \
            becomes 0 it divides by zero",
        )],
        docs: "A weight says how much of a vertex moves with a bone, from 0 to 1.\n\nMakeHuman 2 adds the negative \
            number to the sum of the vertex, divides by the sum, and drops what is below 0. What remains adds up \
            to more than 1, so the vertex shoots away from the body in every pose. Weights that cancel out \
            divide by zero.\n\nRemove the entry or paint the weight again.",
        ..RuleInfo::new("weights-negative", Level::Error, "a weight is negative")
    },
    check: Check::File(run),
};

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(weights) = bones_of(file) else { return };
    let tally = &weights.facts.negative;
    let (Some((bone, _, vertex, weight)), Some(place)) = (tally.first.first(), pair_place(tally)) else { return };
    let message = match tally.count {
        1 => format!("vertex {vertex} has the negative weight {weight} in bone `{bone}`"),
        count => format!("{count} weights are negative, the first is {weight} of vertex {vertex} in bone `{bone}`"),
    };
    let evidence = worst(tally.evidence(weights.facts.pairs), tally);
    out.push(RULE.at(file, place, message).help("remove the entry, or paint the weight again").evidence(evidence));
}
