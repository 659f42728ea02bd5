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

const USUAL: &str =
    "divides the weights of the vertex by their sum: the large one takes nearly all of the vertex";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, USUAL), (Mpfb, "reads the weight as 1")],
    levels: &[(Makehuman2, Level::Info)],
    docs: include_str!("above_one.md").trim_ascii_end(),
    counts: "entries",
    grows: Grows::more(MeasureKind::Weight),
    ..RuleInfo::new(
        "weights-above-one",
        Level::Warning,
        "a weight is larger than 1",
    )
});

const ALONE: Case = &[(
    Mpfb,
    Level::Info,
    "reads the only weight of the vertex as 1, which changes nothing",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let counted = if body.is_mpfb() { all } else { among_smaller };
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        weight,
        place,
    } in tallied(body, counted)
    {
        let first = weight;
        let weight = short(f64::from(weight));
        let message = match tally.count {
            1 => format!("bone `{bone}` has weight {weight} for {vertex}, more than 1"),
            count => {
                let all = format!(
                    "{count} weights are larger than 1, first {weight} of bone `{bone}` for \
                        {vertex}"
                );
                all + &at_worst(tally, first)
            }
        };
        let evidence = worst(tally.evidence(weights.facts.pairs), tally);
        let finding = RULE.at(own.file, place, message);
        let finding = finding
            .help("normalise the weights in the 3D program and export them again")
            .evidence(evidence);
        let is_alone = weights.facts.above_one_alone == tally.count;
        out.push(weigh(
            own,
            if is_alone {
                finding.case(ALONE)
            } else {
                finding
            },
        ));
    }
}

const fn all(facts: &WeightsFacts) -> &PairTally {
    &facts.above_one
}

const fn among_smaller(facts: &WeightsFacts) -> &PairTally {
    &facts.above_others
}
