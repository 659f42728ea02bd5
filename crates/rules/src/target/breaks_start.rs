//! A target that nothing uses and that stops the program all the same.

use super::super::cause::archived::weigh;
use super::super::{Check, Rule, RuleCx};
use super::{targets, unreadable_fields};
use mhlint_diag::{Application::Makehuman2, Finding, Level, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "crashes at start with `ValueError` although nothing uses the file, and leaves an empty \
         compressedtargets.npz that crashes every later start",
    )],
    docs: include_str!("breaks_start.md").trim_ascii_end(),
    counts: "rows",
    ..RuleInfo::new(
        "target-breaks-start",
        Level::Error,
        "an unused target crashes MakeHuman 2 at start",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (target, file, facts) in targets(body).filter(|(target, ..)| target.is_unused) {
        let Some(mut finding) = unreadable_fields::finding(&RULE, file, facts) else {
            continue;
        };
        finding
            .message
            .push_str(", and MakeHuman 2 parses this file at start although nothing uses it");
        out.push(weigh(target, finding).help(
            "fix the row, or move the file out of the target folder; \
                 after a crash also delete compressedtargets.npz",
        ));
    }
}
