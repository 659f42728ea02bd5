//! Weights must not be larger than 1.

use super::super::units::short;
use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied, weigh, worst};
use crate::diag::{
    Application::{Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use crate::repo::Body;

const USUAL: &str = "divides the weights of the vertex by their sum: correct if all weights are per cent; otherwise the large \
    one gets too large a share";

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, USUAL), (Mpfb, "reads the weight as 1")],
    levels: &[(Makehuman2, Level::Info)],
    docs: "A weight is larger than 1. It says how much of a vertex moves with a bone, from 0 to 1; a larger \
        number is usually a percentage or a misplaced decimal point. Up to 1.0001 counts as 1.\n\n\
        MakeHuman 2 divides all weights of a vertex by their sum. Weights in per cent come out as they were painted; one \
        large number among small ones takes nearly all of the vertex. If the vertex has no other weight, its share \
        becomes 1 as it should. Other programs clamp the number or keep it.\n\n\
        Write the share as a number from 0 to 1.",
    counts: "entries",
    ..RuleInfo::new("weights-above-one", Level::Warning, "a weight is larger than 1")
});

const ALONE: Case = &[
    (Makehuman2, Level::Info, BY_ITSELF),
    (Mpfb, Level::Info, "reads the only weight of the vertex as 1, which changes nothing"),
];
const BY_ITSELF: &str = "divides the only weight of the vertex by itself, which changes nothing";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied { own, weights, tally, bone, vertex, weight, place } in tallied(body, |facts| &facts.above_one) {
        let weight = short(f64::from(weight));
        let message = match tally.count {
            1 => format!("bone `{bone}` has weight {weight} for {vertex}, more than 1"),
            count => format!("{count} weights are larger than 1, first {weight} of bone `{bone}` for {vertex}"),
        };
        let evidence = worst(tally.evidence(weights.facts.pairs), tally);
        let finding =
            RULE.at(own.file, place, message).help("leave it if all weights are per cent; otherwise normalise the weights in the 3D program and export them again").evidence(evidence);
        let is_alone = weights.facts.above_one_alone == tally.count;
        out.push(weigh(own, if is_alone { finding.case(ALONE) } else { finding }));
    }
}
