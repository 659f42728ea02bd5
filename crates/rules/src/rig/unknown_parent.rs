//! The parents of bones exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently makes a root of the bone: it and all below it stay behind when the body moves",
    )],
    docs: include_str!("unknown_parent.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-unknown-parent",
        Level::Warning,
        "a bone hangs on a bone that does not exist",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let known: BTreeSet<&str> = rig.bones.iter().map(|bone| bone.name.as_str()).collect();
        let with_parent = rig
            .bones
            .iter()
            .filter_map(|bone| Some((bone.name.as_str(), bone.parent.as_deref()?)));
        let loose: Vec<(&str, &str)> = with_parent
            .filter(|(_, parent)| !known.contains(parent))
            .collect();
        let Some((bone, parent)) = loose.first() else {
            continue;
        };
        let message = format!(
            "parent `{parent}` of bone `{bone}` does not exist{}",
            such(loose.len(), "bones")
        );
        let near = cx
            .suggestions
            .nearest(parent, known.iter().copied().filter(|other| other != bone));
        let names: Vec<&str> = loose.iter().map(|(bone, _)| *bone).collect();
        let finding = at_bones(&RULE, file, rig, &names, "parent", message);
        out.extend(finding.map(|finding| {
            finding.help(did_you_mean(
                near,
                "name a bone of the rig, or write \"\" for a root",
            ))
        }));
    }
}
