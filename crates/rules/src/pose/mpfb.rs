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
    breaks: &[(Mpfb, "lists the pose, and fails with an exception when it is loaded")],
    docs: "A pose of MPFB (`poses/<rig>_fk/<name>.json`, also `_ik` and `_partial`) needs `skeleton_type`, a string, and the \
        objects `bone_rotations` and `bone_translations`. A rotation has three numbers, or four for a quaternion; \
        `bone_rotation_modes` may say which mode a bone has: `QUATERNION` and `AXIS_ANGLE` take four numbers, `XYZ` and its \
        permutations three. A translation has three.\n\n\
        Anything else stops MPFB when the pose is loaded: the bones before it are posed, the others are not.\n\n\
        If `skeleton_type` contains `default`, MPFB measures `spine05`, `spine01` and the bones `shoulder01`, and fails \
        on a rig that does not have them.\n\n\
        NaN, infinity and a quaternion of zeros are taken as they are: the bone has no place any more (a warning).\n\n\
        MPFB copies its own poses into the user's folder once. A broken one is copied as it is, and a copy is never \
        refreshed.\n\n\
        Save the pose again, or correct the value.",
    ..RuleInfo::new("pose-mpfb", Level::Error, "a pose of MPFB that its loader does not take")
});

const NO_SPINE: Case = &[(Mpfb, Level::Error, "fails with `AttributeError` when the pose is loaded")];
const TORN: Case = &[(Mpfb, Level::Warning, "takes the numbers as they are: the bone has no place, or does not turn")];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for file in view.own(Kind::StoredPose) {
        let (Some(pose), rig) = (file.stored_pose(), rig_of_pose(&file.rel)) else { continue };
        // In a folder that no rig reads the pose is not offered, whatever is in it. Where a loose one will lie nobody knows.
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
    let message = format!("`skeleton_type` is that of a default rig, but the folder is that of `{rig}`");
    let finding = RULE.at(file, Place::pointer(["skeleton_type"]), message).key("default").case(NO_SPINE);
    Some(finding.help(format!("write `{rig}`, or move the pose to the folder of its rig")))
}

fn odd(file: &FileFacts, bones: &[NamedAt], what: &str, key: &str) -> Option<Finding> {
    let first = bones.first()?;
    let message = format!("bone `{}` {what}{}", first.name, such(bones.len(), "bones"));
    let finding = RULE.at(file, Place::Pointer(first.pointer.clone()), message).key(key).case(TORN);
    let finding = finding.evidence(Evidence::of_cases(bones.iter().map(|one| one.name.as_str())));
    Some(finding.help("write the numbers of a rotation, or remove the bone"))
}
