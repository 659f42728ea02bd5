//! A bone must list a vertex once.

use super::super::{Check, Rule, RuleCx};
use super::{bones_of, has_unusable_entries, pair_place};
use crate::diag::{Application, Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Safe,
        breaks: &[(
            Application::Makehuman2,
            "uses only one of the two shares in pose mode: the vertex lacks the other and is pulled towards the \
            origin (half way, if they are equal)",
        )],
        docs: "A bone lists a vertex once.\n\nMakeHuman 2 does not merge two entries of one vertex: both count for \
            the sum that it divides by, but posing uses one of them. The missing share pulls the vertex towards \
            the origin. (MakeHuman 1, and the transfer of weights to clothes, add the entries.)\n\nReplace the \
            entries by one with their sum. Where the weights of the vertex then do not add up to 1, the fix divides \
            them by their sum, as the loader does; not where one of them is above 1, which has a rule of its own.",
        ..RuleInfo::new("weights-duplicate-vertex", Level::Warning, "a bone lists a vertex twice")
    },
    check: Check::File(run),
};

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(weights) = bones_of(file) else { return };
    let tally = &weights.facts.duplicate;
    let (Some((bone, _, vertex, _)), Some(place)) = (tally.first.first(), pair_place(tally)) else { return };
    let message = match tally.count {
        1 => format!("bone `{bone}` lists vertex {vertex} twice"),
        count => format!("{count} entries list a vertex again, the first is vertex {vertex} of bone `{bone}`"),
    };
    let finding = RULE.at(file, place, message).help("replace the entries by one with the sum of their weights");
    let mut fix = Fix::new(RULE.info.fix, "replace the entries by one with their sum");
    // What a negative or malformed entry beside them should have been changes the sum, and one beyond float32 cannot be
    // written.
    if weights.facts.negative.count == 0 && !weights.facts.may_overflow && !has_unusable_entries(weights) {
        fix = fix.step(&file.path, Change::Rewrite(Rewrite::MergeWeights));
    }
    out.push(finding.evidence(tally.evidence(weights.facts.pairs)).fix(fix));
}
