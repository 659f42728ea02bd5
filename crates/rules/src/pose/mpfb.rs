//! A stored pose of MPFB can be loaded, and turns bones.

use super::super::unfit::findings;
use super::super::{Check, Rule, RuleCx, such};
use super::mpfb_rigs::has_spine;
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_formats::stored_pose::StoredPose;
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::{View, rig_of_pose};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "lists the pose, and fails with an exception when it is loaded",
    )],
    docs: include_str!("mpfb.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-mpfb",
        Level::Error,
        "a pose of MPFB that its loader does not take",
    )
});

const NO_SPINE: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `AttributeError` when the pose is loaded",
)];
const TORN: Case = &[(
    Mpfb,
    Level::Warning,
    "takes the numbers as they are: the bone has no place, or does not turn",
)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::StoredPose) {
        let (Some(pose), rig) = (file.stored_pose(), rig_of_pose(&file.rel)) else {
            continue;
        };
        // In a folder that no rig reads the pose is not offered, whatever is in it. Where a loose
        // one will lie nobody knows.
        if rig.is_none() && !file.is_loose {
            continue;
        }
        out.extend(findings(&RULE, file, &pose.stops, cx).map(|(_, finding)| finding));
        out.extend(rig.and_then(|rig| without_spine(file, pose, rig)));
        out.extend(odd(file, &pose.non_finite, "has NaN or infinity", "finite"));
        out.extend(odd(file, &pose.zero, "is a quaternion of zeros", "zero"));
    }
}

fn without_spine(file: &FileFacts, pose: &StoredPose, rig: &str) -> Option<Finding> {
    if !pose.is_default || has_spine(rig) != Some(false) {
        return None;
    }
    let message =
        format!("`skeleton_type` is that of a default rig, but the folder is that of `{rig}`");
    let finding = RULE
        .at(file, Place::pointer(["skeleton_type"]), message)
        .key("default")
        .case(NO_SPINE);
    Some(finding.help(format!(
        "write `{rig}`, or move the pose to the folder of its rig"
    )))
}

fn odd(file: &FileFacts, bones: &[NamedAt], what: &str, key: &str) -> Option<Finding> {
    let first = bones.first()?;
    let message = format!("bone `{}` {what}{}", first.name, such(bones.len(), "bones"));
    let finding = RULE
        .at(file, Place::Pointer(first.pointer.clone()), message)
        .key(key)
        .case(TORN);
    let finding = finding.evidence(Evidence::of_cases(
        bones.iter().map(|one| one.name.as_str()),
    ));
    Some(finding.help("write the numbers of a rotation, or remove the bone"))
}
