//! A target that moves nothing at all.

use super::super::{Check, Rule, RuleCx};
use super::targets;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{Body, ReferenceKind};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "loads it, but the slider changes nothing"),
        (Makehuman1, "loads it, but the slider changes nothing"),
        (Mpfb, "loads it, but the slider changes nothing"),
    ],
    docs: include_str!("without_effect.md").trim_ascii_end(),
    counts: "rows, by vertex",
    ..RuleInfo::new(
        "target-without-effect",
        Level::Warning,
        "a target moves nothing",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body) {
        if target.used_as == Some(ReferenceKind::MacroTarget) || !facts.moves_nothing() {
            continue;
        }
        let message = match facts.rows {
            _ if facts.duplicate.count > 0 => {
                "the last row of every vertex is zero, and only that row counts: the target moves \
                    nothing"
                    .to_owned()
            }
            1 => "its only row is zero: the target moves nothing".to_owned(),
            2 => "both rows are zero: the target moves nothing".to_owned(),
            rows => format!("all {rows} rows are zero: the target moves nothing"),
        };
        out.push(
            RULE.at(file, Place::File, message)
                .help(
                    "set the shape key to 1 and export the target again; keep the slider, because \
                        saved models need it",
                )
                .evidence(facts.zero.evidence(facts.rows)),
        );
    }
}
