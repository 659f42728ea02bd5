//! Weights are pairs of vertex and weight.

use super::super::{Check, Rule, RuleCx};
use super::readable;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `ValueError`, `TypeError` or `UFuncTypeError` while loading the weights",
        ),
        (
            Makehuman1,
            "crashes with `IndexError`, `TypeError` or `ValueError` while loading the weights",
        ),
        (
            Mpfb,
            "fails with `TypeError` or `ValueError` while loading the weights",
        ),
    ],
    docs: include_str!("malformed_pair.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "weights-malformed-pair",
        Level::Error,
        "an entry of a bone is not a pair of vertex and weight",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (own, weights) in readable(body) {
        let tally = &weights.facts.malformed;
        let Some((bone, position, ..)) = tally.first.first() else {
            continue;
        };
        let message = match tally.count {
            1 => format!("entry {position} of bone `{bone}` is not a pair `[vertex, weight]`"),
            count => {
                format!(
                    "{count} entries are not pairs `[vertex, weight]`, first entry {position} of \
                        bone `{bone}`"
                )
            }
        };
        let cases = tally
            .first
            .iter()
            .map(|(bone, position, ..)| format!("{bone}[{position}]"));
        let mut evidence =
            Evidence::of_unnamed(cases).out_of(weights.bones.iter().map(|bone| bone.listed).sum());
        evidence.count = tally.count;
        out.push(
            RULE.at(
                own.file,
                Place::pointer(["weights", bone, &position.to_string()]),
                message,
            )
            .help("write a vertex number without a decimal point, and a weight from 0 to 1")
            .parts(weights.facts.malformed_names.names())
            .evidence(evidence),
        );
    }
}
