//! Weights must not be larger than 1.

use super::super::units::short;
use super::super::{Check, Rule, RuleCx};
use super::{Tallied, at_worst, tallied, weigh, worst};
use mhlint_diag::{
    Application::{Makehuman2, Mpfb},
    Case, Finding, Grows, Level, MeasureKind, RuleInfo,
};
use mhlint_formats::mhw::{PairTally, WeightsFacts};
use mhlint_repo::Body;

const USUAL: &str = "divides the weights of the vertex by their sum: the large one takes nearly all of the vertex";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, USUAL), (Mpfb, "reads the weight as 1")],
    levels: &[(Makehuman2, Level::Info)],
    docs: "A weight is larger than 1. It says how much of a vertex moves with a bone, from 0 to 1; a larger \
        number is usually a percentage or a misplaced decimal point. Up to 1.0001 counts as 1.\n\n\
        MakeHuman 2 divides all weights of a vertex by their sum. If the vertex has no other weight, or all its weights are \
        in per cent, they come out as they were painted, and nothing is reported; nor is a weight of up to 2. A larger \
        number among small ones takes nearly all of the vertex. MPFB reads every weight above 1 as 1.\n\n\
        Write the share as a number from 0 to 1.",
    counts: "entries",
    grows: Grows::more(MeasureKind::Weight),
    ..RuleInfo::new("weights-above-one", Level::Warning, "a weight is larger than 1")
});

const ALONE: Case = &[(Mpfb, Level::Info, "reads the only weight of the vertex as 1, which changes nothing")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let counted = if body.is_mpfb() { all } else { among_smaller };
    for Tallied { own, weights, tally, bone, vertex, weight, place } in tallied(body, counted) {
        let first = weight;
        let weight = short(f64::from(weight));
        let message = match tally.count {
            1 => format!("bone `{bone}` has weight {weight} for {vertex}, more than 1"),
            count => {
                let all = format!("{count} weights are larger than 1, first {weight} of bone `{bone}` for {vertex}");
                all + &at_worst(tally, first)
            }
        };
        let evidence = worst(tally.evidence(weights.facts.pairs), tally);
        let finding = RULE.at(own.file, place, message);
        let finding = finding.help("normalise the weights in the 3D program and export them again").evidence(evidence);
        let is_alone = weights.facts.above_one_alone == tally.count;
        out.push(weigh(own, if is_alone { finding.case(ALONE) } else { finding }));
    }
}

const fn all(facts: &WeightsFacts) -> &PairTally {
    &facts.above_one
}

const fn among_smaller(facts: &WeightsFacts) -> &PairTally {
    &facts.above_others
}
