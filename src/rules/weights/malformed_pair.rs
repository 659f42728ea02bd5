//! Weights are pairs of vertex and weight.

use super::super::{Check, Rule, RuleCx};
use super::bones_of;
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "stops with an exception while the weights are loaded (ValueError, TypeError or UFuncTypeError)",
        )],
        docs: "The entries of a bone are pairs `[vertex, weight]`: a whole number without a point, and a \
            number.\n\nMakeHuman 2 makes a table of them and stops when an entry has another length or type, \
            `[12.0, 0.5]` included.\n\nCorrect the entry or remove it.",
        ..RuleInfo::new("weights-malformed-pair", Level::Error, "an entry of a bone is not a pair of vertex and weight")
    },
    check: Check::File(run),
};

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(weights) = bones_of(file) else { return };
    let tally = &weights.facts.malformed;
    let Some((bone, position, ..)) = tally.first.first() else { return };
    let message = match tally.count {
        1 => format!("entry {position} of bone `{bone}` is no pair `[vertex, weight]`"),
        count => {
            format!("{count} entries are no pairs `[vertex, weight]`, the first is entry {position} of bone `{bone}`")
        }
    };
    let cases = tally.first.iter().map(|(bone, position, ..)| format!("{bone}[{position}]"));
    let mut evidence = Evidence::of_unnamed(cases).out_of(weights.bones.iter().map(|bone| bone.listed).sum());
    evidence.count = tally.count;
    out.push(
        RULE.at(file, Place::pointer(["weights", bone, &position.to_string()]), message)
            .help("write a vertex number without a point and a weight between 0 and 1")
            .parts(weights.facts.malformed_names.names())
            .evidence(evidence),
    );
}
