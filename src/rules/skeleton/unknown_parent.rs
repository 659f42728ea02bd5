//! The parent of a bone must be a bone of the skeleton.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::hierarchy::hierarchy;
use super::rigs;
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "rejects the skeleton and logs a line")],
    docs: "A bone names a parent that does not exist. `parent` is the name of another bone of the same file; only \
        the root has none.\n\n\
        MakeHuman 2 rejects the whole skeleton.\n\n\
        Correct the name, or add the missing bone. Names must match exactly, including capitals.",
    counts: "bones",
    ..RuleInfo::new("skeleton-unknown-parent", Level::Error, "a bone names a parent that does not exist")
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        let names = || rig.skeleton.bones.iter().map(|bone| bone.name.as_str());
        for (parent, bones) in hierarchy(rig.skeleton).unknown_parents {
            let Some(first) = bones.first() else { continue };
            let message = match bones.len() {
                1 if parent.is_empty() => format!("`parent` of bone `{first}` is an empty name"),
                count if parent.is_empty() => format!("`parent` of {count} bones is an empty name"),
                1 => format!("parent `{parent}` of bone `{first}` does not exist"),
                count => format!("parent `{parent}` of {count} bones does not exist"),
            };
            let help = did_you_mean(
                cx.suggestions.nearest(parent, names()),
                "name a bone of this skeleton, or write null for the root",
            );
            out.push(
                RULE.at(rig.file, Place::pointer(["bones", first, "parent"]), message)
                    .key(parent)
                    .help(help)
                    .evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len())),
            );
        }
    }
}
