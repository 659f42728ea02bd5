//! Each left bone has a right counterpart, and each right bone a left one.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, such};
use super::{at_bones, pairs};
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::{RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "builds the bone like any other; tools that mirror by name leave it out",
    )],
    docs: include_str!("name_asymmetry.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-name-asymmetry",
        Level::Info,
        "a bone has no left/right counterpart",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| file.part != RigPart::Asset)
    {
        let names: BTreeSet<&str> = rig.bones.iter().map(|bone| bone.name.as_str()).collect();
        // A missing counterpart that is named as a parent is reported by `rig-unknown-parent`.
        let asked: BTreeSet<&str> = rig
            .bones
            .iter()
            .filter_map(|bone| bone.parent.as_deref())
            .collect();
        let partner = |name: &str| Some(pairs::of(name)?.1);
        let lonely: Vec<(&str, String)> = names
            .iter()
            .filter_map(|name| Some((*name, partner(name)?)))
            .filter(|(_, partner)| !names.contains(&**partner) && !asked.contains(&**partner))
            .collect();
        let Some((bone, partner)) = lonely.first() else {
            continue;
        };
        let message = format!(
            "bone `{bone}` has no counterpart `{partner}`{}",
            such(lonely.len(), "bones")
        );
        let near = cx
            .suggestions
            .nearest(partner, names.iter().copied().filter(|other| other != bone));
        let found: Vec<&str> = lonely.iter().map(|(name, _)| *name).collect();
        let finding = at_bones(&RULE, file, rig, &found, "", message);
        let otherwise =
            format!("leave it if the bone has no counterpart; otherwise add `{partner}`");
        let misspelt = |near| {
            format!("if `{near}` is meant, rename it to `{partner}`, here and in the weights")
        };
        out.extend(finding.map(|finding| finding.help(near.map_or(otherwise, misspelt))));
    }
}
