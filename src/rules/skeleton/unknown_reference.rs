//! Referenced bones must exist in the default skeleton.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::{Rig, rigs};
use crate::diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::mhskel::Bone;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores these names; the bone gets weights and poses from its other references, if any")],
    docs: "A bone refers to bones that the default skeleton does not have. `reference` and `weights_reference` \
        list bones of the default skeleton (`pose-skeleton` of `base.json`) whose poses and weights a bone takes \
        over.\n\n\
        MakeHuman 2 ignores unknown names. It reads a string in place of the list letter by letter: `\"head\"` \
        means the bones `h`, `e`, `a` and `d`. MakeHuman 1 accepts a single name.\n\n\
        Correct the names, and write a single name as a list.",
    ..RuleInfo::new(
        "skeleton-unknown-reference",
        Level::Warning,
        "a bone refers to bones that the default skeleton does not have",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(default) = body.default_rig() else { return };
    let Some(pose) = default.skeleton() else { return };
    let known: BTreeSet<&str> = pose.bones.iter().map(|bone| bone.name.as_str()).collect();
    if known.is_empty() {
        return;
    }
    for rig in rigs(body) {
        let (mut unknown, mut found) = (Vec::new(), Vec::new());
        for bone in &rig.skeleton.bones {
            for (member, names) in [("reference", &bone.reference), ("weights_reference", &bone.weights_reference)] {
                let text = bone.text_references.iter().find(|(key, _)| *key == member);
                let names: Vec<&String> =
                    names.iter().flatten().filter(|name| !known.contains(name.as_str())).collect();
                match text {
                    Some((_, text)) if !names.is_empty() => found.push(spelled_out(&rig, bone, member, text)),
                    Some(_) => {}
                    None => unknown.extend(names.into_iter().map(|name| (bone.name.as_str(), member, name.as_str()))),
                }
            }
        }
        found.extend(finding(&rig, &unknown, &known, cx));
        // Others refer to the default skeleton; what it refers to itself is never read.
        let is_default = std::ptr::eq(rig.file, default.file);
        out.extend(found.into_iter().map(|one| if is_default { one.case(OF_DEFAULT) } else { one }));
    }
}

const OF_DEFAULT: Case = &[(Makehuman2, Level::Info, "never reads references in the default skeleton")];

fn spelled_out(rig: &Rig<'_>, bone: &Bone, member: &str, text: &str) -> Finding {
    let message = format!("`{member}` of bone `{}` is the string `{text}`, which is read letter by letter", bone.name);
    RULE.at(rig.file, Place::pointer(["bones", &bone.name, member]), message)
        .key(format!("{}/{member}", bone.name))
        .help(format!("write a list: `[\"{text}\"]`"))
}

fn finding(rig: &Rig<'_>, unknown: &[(&str, &str, &str)], known: &BTreeSet<&str>, cx: &RuleCx<'_>) -> Option<Finding> {
    let (bone, member, name) = unknown.first()?;
    let more = such(unknown.len(), "names");
    let message = format!("`{member}` of bone `{bone}` names `{name}`, which the default skeleton does not have{more}");
    let help = did_you_mean(cx.suggestions.nearest(name, known.iter().copied()), "name bones of the default skeleton");
    let cases = unknown.iter().map(|(bone, _, name)| format!("{bone}: {name}"));
    Some(
        RULE.at(rig.file, Place::pointer(["bones", bone, member]), message)
            .help(help)
            .evidence(Evidence::of_cases(cases)),
    )
}
