//! Weights that the loader drops.

use super::super::{Check, Rule, RuleCx};
use super::loss::noticeable_loss;
use super::{Tallied, has_unusable_entries, tallied};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo,
};
use mhlint_repo::{Body, FileFacts};

const USUAL: &str = "drops the entry: it keeps only weights above 0.0001";

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[(Makehuman2, USUAL), (Makehuman1, USUAL)],
    docs: include_str!("below_threshold.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "weights-below-threshold",
        Level::Info,
        "a weight is too small to have an effect",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Where the loss can be seen, the same entries are told by `weights-lost-after-threshold`.
    let told = noticeable_loss(body, cx).map(|loss| loss.file);
    let is_told = |file: &FileFacts| told.is_some_and(|told| std::ptr::eq(told, file));
    let of_body =
        tallied(body, |facts| &facts.below_threshold).filter(|one| one.own.name.is_some());
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        weight,
        place,
    } in of_body.filter(|one| !is_told(one.own.file) && !has_unusable_entries(one.weights))
    {
        let message = match tally.count {
            1 => format!("bone `{bone}` has weight {weight} for {vertex}, too small to be kept"),
            count => format!(
                "{count} of {} weights are too small to be kept, first {weight} for {vertex} in \
                    bone `{bone}`",
                weights.facts.pairs
            ),
        };
        let fix = Fix::new(RULE.info.fix, "remove the entries");
        let fix = fix.step(&own.file.path, Change::Rewrite(Rewrite::DropSmallWeights));
        let evidence = tally.evidence(weights.facts.pairs);
        out.push(
            RULE.at(own.file, place, message)
                .help("remove the entries")
                .evidence(evidence)
                .fix(fix),
        );
    }
}
