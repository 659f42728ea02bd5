//! A bone must list a vertex once.

use super::super::{Check, Rule, RuleCx};
use super::{Tallied, has_unusable_entries, tallied, weigh};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Change, Finding, Fix, FixKind, Level, Rewrite, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    fix: FixKind::Safe,
    breaks: &[
        (
            Makehuman2,
            "uses only one of the entries: in pose mode the vertex moves towards the origin, half \
             way if both entries are equal",
        ),
        (Makehuman1, "adds the weights, which changes nothing"),
        (Mpfb, "adds the weights, up to 1"),
    ],
    levels: &[(Makehuman1, Level::Info), (Mpfb, Level::Info)],
    docs: include_str!("duplicate_vertex.md").trim_ascii_end(),
    counts: "entries",
    ..RuleInfo::new(
        "weights-duplicate-vertex",
        Level::Warning,
        "a bone lists a vertex more than \
        once",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for Tallied {
        own,
        weights,
        tally,
        bone,
        vertex,
        place,
        ..
    } in tallied(body, |facts| &facts.duplicate)
    {
        let message = match tally.count {
            1 => format!("bone `{bone}` lists {vertex} twice"),
            count => format!(
                "{count} entries repeat a vertex of their bone, first {vertex} in bone `{bone}`"
            ),
        };
        let finding = RULE
            .at(own.file, place, message)
            .help("replace the entries with one that has the sum of their weights");
        let mut fix = Fix::new(
            RULE.info.fix,
            "replace the entries with one that has their sum",
        );
        // What a negative or malformed entry beside them should have been changes the sum, and one
        // beyond float32 cannot be written.
        if weights.facts.negative.count == 0
            && !weights.facts.may_overflow
            && !has_unusable_entries(weights)
        {
            fix = fix.step(&own.file.path, Change::Rewrite(Rewrite::MergeWeights));
        }
        out.push(weigh(
            own,
            finding
                .evidence(tally.evidence(weights.facts.pairs))
                .fix(fix),
        ));
    }
}
