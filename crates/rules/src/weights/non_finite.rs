//! Weights must be finite.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, tallied, weigh};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::Body;

const USUAL: &str = "drops all weights of the vertex and does not move it with the root bone: in \
    pose mode it lies at the origin";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, USUAL),
        (Makehuman1, USUAL),
        (
            Mpfb,
            "does not move the vertex if the weight is NaN; reads Infinity as 1",
        ),
    ],
    levels: &[(Mpfb, Level::Warning)],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "weights-non-finite",
        Level::Error,
        "a weight is NaN or infinite",
    )
});

/// Of an asset's own weights.
const OF_ASSET: Case = &[
    (Makehuman2, Level::Error, USUAL),
    (
        Makehuman1,
        Level::Warning,
        "assigns the vertex to the bone `root`: it does not move with the limbs of the body",
    ),
];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        weight,
        place,
    } in tallied(body, |facts| &facts.non_finite)
    {
        let message = match tally.count {
            1 => format!("bone `{bone}` has weight {weight} for {vertex}"),
            count => {
                format!(
                    "{count} weights are NaN or infinite, first {weight} for {vertex} in bone \
                        `{bone}`"
                )
            }
        };
        let evidence = tally.evidence(weights.facts.pairs);
        let finding = RULE
            .at(own.file, place, message)
            .help("write a number from 0 to 1")
            .evidence(evidence);
        let is_of_asset = own.name.is_none();
        out.push(weigh(
            own,
            if is_of_asset {
                finding.case(OF_ASSET)
            } else {
                finding
            },
        ));
    }
}
