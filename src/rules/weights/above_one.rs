//! Weights must not be larger than 1.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied, weigh, worst};
use crate::diag::{Application, Case, Finding, Level, RuleInfo};
use crate::repo::Body;

const USUAL: &str = "divides the weights of the vertex by their sum: the bone takes over more of the vertex than the \
    others were meant to leave it";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, USUAL),
            (Application::Makehuman1, USUAL),
            (Application::Mpfb, "takes the weight as 1"),
        ],
        docs: "A weight says how much of a vertex moves with a bone, from 0 to 1. More is impossible; it is usually \
            a percentage or a slip of the decimal point.\n\nMakeHuman 2 divides all weights of a vertex by their \
            sum, so that the mesh holds together, but the shares are not the painted ones. Other programs clamp \
            or keep the number. Where the weight is the only one of its vertex \
            the share is the whole all the same: an info. Up to 1.0001 counts as 1.\n\nWrite the share as a number up to 1.",
        ..RuleInfo::new("weights-above-one", Level::Warning, "a weight is larger than 1")
    },
    check: Check::Body(run),
};

const ALONE: Case = &[
    (Application::Makehuman2, Level::Info, BY_ITSELF),
    (Application::Makehuman1, Level::Info, BY_ITSELF),
    (Application::Mpfb, Level::Info, "takes the only weight of the vertex as 1: nothing happens"),
];
const BY_ITSELF: &str = "divides the only weight of the vertex by itself: nothing happens";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied { own, weights, tally, bone, vertex, weight, place } in tallied(body, |facts| &facts.above_one) {
        let message = match tally.count {
            1 => format!("vertex {vertex} has weight {weight} in bone `{bone}`, more than 1"),
            count => {
                format!("{count} weights are more than 1, the first is {weight} of vertex {vertex} in bone `{bone}`")
            }
        };
        let evidence = worst(tally.evidence(weights.facts.pairs), tally);
        let finding =
            RULE.at(own.file, place, message).help("write the share as a number from 0 to 1").evidence(evidence);
        let is_alone = weights.facts.above_one_alone == tally.count;
        out.push(weigh(own, if is_alone { finding.case(ALONE) } else { finding }));
    }
}
