//! A bone must list a vertex once.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, has_unusable_entries, tallied, weigh};
use crate::diag::{Application, Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        fix: FixKind::Safe,
        breaks: &[
            (
                Application::Makehuman2,
                "uses only one of the two shares in pose mode: the vertex lacks the other and is pulled towards the \
            origin (half way, if they are equal)",
            ),
            (Application::Makehuman1, "adds the shares: nothing happens"),
            (Application::Mpfb, "adds the shares, up to 1"),
        ],
        levels: &[(Application::Makehuman1, Level::Info), (Application::Mpfb, Level::Info)],
        docs: "A bone lists a vertex once.\n\nMakeHuman 2 does not merge two entries of one vertex: both count for \
            the sum that it divides by, but posing uses one of them. The missing share pulls the vertex towards \
            the origin. (MakeHuman 1, and the transfer of weights to clothes, add the entries.)\n\nReplace the \
            entries by one with their sum. Where the weights of the vertex then do not add up to 1, the fix divides \
            them by their sum, as the loader does; not where one of them is above 1, which has a rule of its own.",
        ..RuleInfo::new("weights-duplicate-vertex", Level::Warning, "a bone lists a vertex twice")
    },
    check: Check::Body(run),
};

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied { own, weights, tally, bone, vertex, place, .. } in tallied(body, |facts| &facts.duplicate) {
        let message = match tally.count {
            1 => format!("bone `{bone}` lists vertex {vertex} twice"),
            count => format!("{count} entries list a vertex again, the first is vertex {vertex} of bone `{bone}`"),
        };
        let finding =
            RULE.at(own.file, place, message).help("replace the entries by one with the sum of their weights");
        let mut fix = Fix::new(RULE.info.fix, "replace the entries by one with their sum");
        // What a negative or malformed entry beside them should have been changes the sum, and one beyond float32 cannot be
        // written.
        if weights.facts.negative.count == 0 && !weights.facts.may_overflow && !has_unusable_entries(weights) {
            fix = fix.step(&own.file.path, Change::Rewrite(Rewrite::MergeWeights));
        }
        out.push(weigh(own, finding.evidence(tally.evidence(weights.facts.pairs)).fix(fix)));
    }
}
