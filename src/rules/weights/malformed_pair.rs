//! Weights are pairs of vertex and weight.

use super::super::{Check, Rule, RuleCx};
use super::readable;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[
            (
                Application::Makehuman2,
                "stops with an exception while the weights are loaded (ValueError, TypeError or UFuncTypeError)",
            ),
            (
                Application::Makehuman1,
                "stops with an exception while the weights are loaded (IndexError, TypeError or ValueError)",
            ),
            (Application::Mpfb, "stops with an exception while the weights are loaded (TypeError or ValueError)"),
        ],
        docs: "The entries of a bone are pairs `[vertex, weight]`: a whole number without a point, and a \
            number.\n\nMakeHuman 2 makes a table of them and stops when an entry has another length or type, \
            `[12.0, 0.5]` included.\n\nCorrect the entry or remove it.",
        ..RuleInfo::new("weights-malformed-pair", Level::Error, "an entry of a bone is not a pair of vertex and weight")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (own, weights) in readable(body) {
        let tally = &weights.facts.malformed;
        let Some((bone, position, ..)) = tally.first.first() else { continue };
        let message = match tally.count {
            1 => format!("entry {position} of bone `{bone}` is no pair `[vertex, weight]`"),
            count => {
                format!(
                    "{count} entries are no pairs `[vertex, weight]`, the first is entry {position} of bone `{bone}`"
                )
            }
        };
        let cases = tally.first.iter().map(|(bone, position, ..)| format!("{bone}[{position}]"));
        let mut evidence = Evidence::of_unnamed(cases).out_of(weights.bones.iter().map(|bone| bone.listed).sum());
        evidence.count = tally.count;
        out.push(
            RULE.at(own.file, Place::pointer(["weights", bone, &position.to_string()]), message)
                .help("write a vertex number without a point and a weight between 0 and 1")
                .parts(weights.facts.malformed_names.names())
                .evidence(evidence),
        );
    }
}
