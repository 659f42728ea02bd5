//! The parent of a bone must be a bone of the skeleton.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::hierarchy::hierarchy;
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "rejects the skeleton and logs a line"),
        (Makehuman1, LOST),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("unknown_parent.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-unknown-parent",
        Level::Error,
        "a bone names a parent that does not exist",
    )
});

const LOST: &str =
    "drops the bone and all below it with a line in the log; other bones get their weights";
const NO_BONE: Case = &[(
    Makehuman1,
    Level::Error,
    "drops all bones, and fails with `IndexError` when the skeleton is chosen",
)];
const OF_BASE: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `KeyError` at start: without these bones expressions and foot poses are missing",
)];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let is_bare = body.is_makehuman1() && rig.skeleton.breadth_first().is_empty();
        let names = || rig.skeleton.bones.iter().map(|bone| bone.name.as_str());
        for (parent, bones) in hierarchy(rig.skeleton).unknown_parents {
            let Some(first) = bones.first() else { continue };
            if parent.is_empty() && body.is_makehuman1() {
                continue;
            }
            let message = match bones.len() {
                1 if parent.is_empty() => format!("`parent` of bone `{first}` is an empty name"),
                count if parent.is_empty() => format!("`parent` of {count} bones is an empty name"),
                1 => format!("parent `{parent}` of bone `{first}` does not exist"),
                count => format!("parent `{parent}` of {count} bones does not exist"),
            };
            let is_null = matches!(parent, "None" | "none" | "null" | "NULL");
            let near = if is_null {
                None
            } else {
                cx.suggestions.nearest(parent, names())
            };
            let otherwise = if is_null {
                "write null without quotes for the root"
            } else {
                "name a bone of this skeleton, or write null for the root"
            };
            let help = did_you_mean(near, otherwise);
            let finding = RULE
                .at(
                    rig.file,
                    Place::pointer(["bones", first, "parent"]),
                    message,
                )
                .key(parent)
                .help(help)
                .evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len()));
            out.push(match rig.own.is_default {
                true => finding.case(OF_BASE),
                false if is_bare => finding.case(NO_BONE),
                false => finding,
            });
        }
    }
}
