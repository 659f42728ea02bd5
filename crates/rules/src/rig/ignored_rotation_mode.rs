//! MPFB keeps rotation modes only in rigs for Rigify and in sub-rigs.

use super::super::{Check, Rule, RuleCx, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Finding, Level, RuleInfo};
use mhlint_repo::mpfb::{RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "silently sets the mode of all bones of the rig to XYZ",
    )],
    docs: include_str!("ignored_rotation_mode.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-ignored-rotation-mode",
        Level::Warning,
        "a rotation mode that is overwritten",
    )
});

/// The rotation modes that Blender knows, without `XYZ`, which MPFB gives to all bones. Any other
/// mode stops the loader (`rig-enum`).
const OVERWRITTEN: [&str; 7] = [
    "QUATERNION",
    "XZY",
    "YXZ",
    "YZX",
    "ZXY",
    "ZYX",
    "AXIS_ANGLE",
];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| matches!(file.part, RigPart::Standard | RigPart::Custom))
    {
        let with_mode = rig
            .bones
            .iter()
            .filter_map(|bone| Some((bone.name.as_str(), bone.rotation_mode.as_deref()?)));
        let lost: Vec<(&str, &str)> = with_mode
            .filter(|(_, mode)| OVERWRITTEN.contains(mode))
            .collect();
        let Some((bone, mode)) = lost.first() else {
            continue;
        };
        let message = format!(
            "bone `{bone}` gets XYZ instead of `{mode}`{}",
            such(lost.len(), "bones")
        );
        let names: Vec<&str> = lost.iter().map(|(bone, _)| *bone).collect();
        let finding = at_bones(&RULE, file, rig, &names, "rotation_mode", message);
        out.extend(finding.map(|finding| finding.help("remove `rotation_mode`")));
    }
}
