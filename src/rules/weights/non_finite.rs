//! Weights must be finite.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied, weigh};
use crate::diag::{Application, Finding, Level, RuleInfo};
use crate::repo::Body;

const USUAL: &str = "loses all weights of the vertex and does not give it to the root bone: in pose mode it lies at the \
    origin";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (Application::Makehuman2, USUAL),
            (Application::Makehuman1, USUAL),
            (Application::Mpfb, "no longer moves the vertex where the weight is NaN; takes Infinity as 1"),
        ],
        levels: &[(Application::Mpfb, Level::Warning)],
        docs: "NaN and Infinity are read by Python's JSON reader, and a number beyond the range of float32 becomes \
            infinite.\n\nMakeHuman 2 divides by the sum of the vertex, which is then no number either; every \
            entry of the vertex is dropped, and it is not given to the root bone. Entering pose mode pulls the \
            vertex to the origin. Other readers refuse the file.\n\nPaint the weight of the vertex again.",
        ..RuleInfo::new("weights-non-finite", Level::Error, "a weight is not a number or infinite")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied { own, weights, tally, bone, vertex, weight, place } in tallied(body, |facts| &facts.non_finite) {
        let message = match tally.count {
            1 => format!("vertex {vertex} has weight {weight} in bone `{bone}`"),
            count => {
                format!("{count} weights are not finite, the first is {weight} of vertex {vertex} in bone `{bone}`")
            }
        };
        let evidence = tally.evidence(weights.facts.pairs);
        let finding = RULE.at(own.file, place, message).help("write a number from 0 to 1").evidence(evidence);
        out.push(weigh(own, finding));
    }
}
