//! Weights that the loader drops.

use super::super::{Check, Rule, RuleCx};
use super::loss::noticeable_loss;
use super::{Tallied, has_unusable_entries, tallied};
use crate::diag::{Application, Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo};
use crate::repo::{Body, FileFacts};

const USUAL: &str = "drops the entry: it keeps weights above 0.0001 only";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Safe,
        breaks: &[(Application::Makehuman2, USUAL), (Application::Makehuman1, USUAL)],
        docs: "After dividing by the sum of a vertex, MakeHuman keeps weights above 0.0001. Smaller ones, zeros \
            among them, only make the file larger; their share is not given to the other bones.\n\nRemove the \
            entries. Then the other bones of the vertex get their share, at most 0.0001 for each; a bone that \
            nothing is left of goes, too. What is lost so much of that it can be seen is \
            `weights-lost-after-threshold`.",
        ..RuleInfo::new("weights-below-threshold", Level::Info, "a weight is too small to have an effect")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Where the loss can be seen, the same entries are told by `weights-lost-after-threshold`.
    let told = noticeable_loss(body, cx).map(|loss| loss.file);
    let is_told = |file: &FileFacts| told.is_some_and(|told| std::ptr::eq(told, file));
    let of_body = tallied(body, |facts| &facts.below_threshold).filter(|one| one.own.name.is_some());
    for Tallied { own, weights, tally, bone, vertex, weight, place } in
        of_body.filter(|one| !is_told(one.own.file) && !has_unusable_entries(one.weights))
    {
        let message = match tally.count {
            1 => format!("weight {weight} of vertex {vertex} in bone `{bone}` is too small to be kept"),
            count => format!(
                "{count} of {} weights are too small to be kept, the first is {weight} of vertex {vertex} in bone `{bone}`",
                weights.facts.pairs
            ),
        };
        let fix = Fix::new(RULE.info.fix, "remove the entries");
        let fix = fix.step(&own.file.path, Change::Rewrite(Rewrite::DropSmallWeights));
        let evidence = tally.evidence(weights.facts.pairs);
        out.push(RULE.at(own.file, place, message).help("remove them").evidence(evidence).fix(fix));
    }
}
