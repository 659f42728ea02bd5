//! Weights must not be negative.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, at_worst, tallied, weigh, worst};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_repo::Body;

const USUAL: &str = "drops the weight, so that the other bones pull the vertex too strongly; \
    divides by zero if no weight is left";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, USUAL),
        (Makehuman1, USUAL),
        (Mpfb, "reads the weight as 0"),
    ],
    levels: &[(Mpfb, Level::Warning), (Makehuman1, Level::Warning)],
    docs: include_str!("negative.md").trim_ascii_end(),
    counts: "entries",
    grows: Grows::more(MeasureKind::Weight),
    ..RuleInfo::new("weights-negative", Level::Error, "a weight is negative")
});

/// Of an asset's own weights.
const OF_ASSET: Case = &[
    (Makehuman2, Level::Error, USUAL),
    (
        Makehuman1,
        Level::Warning,
        "makes the other weights of the vertex larger than 1: it moves too far in poses",
    ),
];
const ALONE: Case = &[
    (Makehuman2, Level::Info, BY_NEGATIVE),
    (Makehuman1, Level::Info, BY_NEGATIVE),
];
const BY_NEGATIVE: &str =
    "divides the weight by the negative sum of its vertex, which gives the right share";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        weight,
        place,
    } in tallied(body, |facts| &facts.negative)
    {
        let message = match tally.count {
            1 => format!("bone `{bone}` has the negative weight {weight} for {vertex}"),
            count => {
                let first = format!(
                    "{count} weights are negative, first {weight} for {vertex} in bone `{bone}`"
                );
                first + &at_worst(tally, weight)
            }
        };
        let evidence = worst(tally.evidence(weights.facts.pairs), tally);
        let finding = RULE
            .at(own.file, place, message)
            .help("remove the entry, or paint the weight again")
            .evidence(evidence);
        let is_harmless = weights.facts.negative_alone == tally.count;
        let finding = match own.name {
            _ if is_harmless => finding.case(ALONE),
            None => finding.case(OF_ASSET),
            Some(_) => finding,
        };
        out.push(weigh(own, finding));
    }
}
