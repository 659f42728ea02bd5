//! Bendy bones have segments and handles as Blender takes them.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently takes the nearest number of segments, 1 or 32",
    )],
    docs: include_str!("bendy_bone.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-bendy-bone",
        Level::Warning,
        "a bendy bone has too many segments or an unknown handle",
    )
});

const NO_HANDLE: Case = &[(Mpfb, Level::Warning, "silently gives the bone no handle")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        let segmented = rig
            .bones
            .iter()
            .filter_map(|bone| Some((bone.name.as_str(), bone.segments?)));
        let clamped: Vec<(&str, f64)> = segmented
            .filter(|(_, segments)| !(1.0..=32.0).contains(segments))
            .collect();
        if let Some((bone, segments)) = clamped.first() {
            let message = format!(
                "bone `{bone}` has {segments} segments, outside 1 to 32{}",
                such(clamped.len(), "bones")
            );
            let names: Vec<&str> = clamped.iter().map(|(bone, _)| *bone).collect();
            let finding = at_bones(&RULE, file, rig, &names, "bendy_bone", message);
            out.extend(
                finding.map(|finding| finding.key("segments").help("write a number from 1 to 32")),
            );
        }
        let known: BTreeSet<&str> = rig.bones.iter().map(|bone| bone.name.as_str()).collect();
        let handles = rig
            .bones
            .iter()
            .flat_map(|bone| bone.handles.iter().map(move |handle| (bone, handle)));
        let lost: Vec<_> = handles
            .filter(|(_, (_, name))| !known.contains(name.as_str()))
            .collect();
        let Some((bone, (key, name))) = lost.first() else {
            continue;
        };
        let more = such(lost.len(), "handles");
        let message = format!(
            "`{key}` of bone `{}` names bone `{name}`, which does not exist{more}",
            bone.name
        );
        let names: Vec<&str> = lost.iter().map(|(bone, _)| bone.name.as_str()).collect();
        let help = did_you_mean(
            cx.suggestions.nearest(name, known.iter().copied()),
            "name a bone of the rig",
        );
        let finding = at_bones(&RULE, file, rig, &names, "bendy_bone", message);
        out.extend(finding.map(|finding| finding.key("handle").case(NO_HANDLE).help(help)));
    }
}
