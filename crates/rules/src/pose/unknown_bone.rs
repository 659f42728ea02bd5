//! Joints of a motion, and bones of pose units, must be bones of the skeleton that is posed.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{imported_joint, units_bone};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_discover::library_of;
use mhlint_formats::bvh::{Joint, Motion};
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::{Body, FileFacts, StoredBones};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently ignores the joint: its bone stays in the rest pose",
        ),
        (
            Makehuman1,
            "does not show the pose: it was made for another rig",
        ),
        (Mpfb, "silently passes over the bone: it stays as it is"),
    ],
    levels: &[(Makehuman1, Level::Error)],
    docs: include_str!("unknown_bone.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-unknown-bone",
        Level::Warning,
        "a pose names a bone that the skeleton does not have",
    )
});

const REST_POSE: Case = &[(
    Makehuman2,
    Level::Warning,
    "shows the rest pose: no joint is a bone",
)];

/// The joint by which MakeHuman 1 tells poses for its rig, and their size
/// (`docs/loaders/makehuman1/poses.md#lines-of-a-motion`).
const COMPARED: &str = "upperleg02.L";

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(body.stored_poses.iter().filter_map(|pose| stored(pose, cx)));
    if body.is_mpfb() {
        return out.extend(imported_joint::findings(&RULE, body, cx));
    }
    if body.is_makehuman1() {
        let listed = body
            .motions
            .iter()
            .filter(|(file, _)| library_of(&file.rel).is_some());
        return out.extend(listed.filter_map(|(file, motion)| foreign(file, motion)));
    }
    let Some((rig, skeleton)) = body
        .default_rig()
        .and_then(|rig| Some((rig, rig.skeleton()?)))
    else {
        return;
    };
    let bones: BTreeSet<&str> = skeleton
        .bones
        .iter()
        .map(|bone| bone.name.as_str())
        .collect();
    let own = body.pose_units.iter().filter_map(|units| units.units);
    for units in own.filter(|(file, _)| !bones.is_empty() && body.layers.is_checked(file)) {
        out.extend(units_bone::finding(&RULE, units, rig, &bones, cx));
    }
    // A skeleton without bones, and a motion of which not all joints could be read, have findings
    // of their own.
    let is_read = |motion: &Motion| {
        motion
            .fault
            .as_ref()
            .is_none_or(|fault| fault.kind.is_of_frames())
    };
    for (file, motion) in body
        .motions
        .iter()
        .filter(|(_, motion)| !bones.is_empty() && is_read(motion))
    {
        let is_unknown = |joint: &&Joint| !bones.contains(&*joint.name);
        let unknown: Vec<&Joint> = motion.joints.iter().filter(is_unknown).collect();
        let Some(first) = unknown.first() else {
            continue;
        };
        let (count, all, name) = (unknown.len(), motion.joints.len(), rig.file.file_name());
        let message = match count {
            _ if count == all => format!(
                "none of the {all} joints is a bone of `{name}`, first `{}`",
                first.name
            ),
            1 => format!("joint `{}` is not a bone of `{name}`", first.name),
            _ => format!(
                "{count} of {all} joints are not bones of `{name}`, first `{}`",
                first.name
            ),
        };
        let near = cx
            .suggestions
            .nearest(&first.name, bones.iter().copied())
            .filter(|_| count < all);
        let evidence =
            Evidence::of_cases(unknown.iter().map(|joint| joint.name.to_string())).out_of(all);
        let help = did_you_mean(
            near,
            "export the motion for the rig of this base, or rename the joints",
        );
        let finding = RULE.at(file, Place::Span(first.span.clone()), message);
        let finding = finding
            .against(&rig.file.path)
            .evidence(evidence)
            .help(help);
        out.push(if count == all {
            finding.case(REST_POSE)
        } else {
            finding
        });
    }
}

/// The bones of a stored pose that its rig does not have.
fn stored(pose: &StoredBones<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    let unknown: Vec<&NamedAt> = pose
        .named
        .iter()
        .filter(|bone| !pose.known.contains(&*bone.name))
        .collect();
    let first = unknown.first()?;
    let rig = pose.rig.file_name();
    let names: BTreeSet<&str> = unknown.iter().map(|bone| &*bone.name).collect();
    let message = match names.len() {
        1 => format!("bone `{}` does not exist in `{rig}`", first.name),
        count => format!(
            "{count} bones do not exist in `{rig}`, first `{}`",
            first.name
        ),
    };
    let near = cx
        .suggestions
        .nearest(&first.name, pose.known.iter().copied());
    let help = did_you_mean(
        near,
        "name bones of the rig, or move the pose to the folder of its rig",
    );
    let finding = RULE
        .at(pose.file, Place::Key(first.pointer.clone()), message)
        .against(&pose.rig.path);
    Some(
        finding
            .key("stored")
            .help(help)
            .evidence(Evidence::of_cases(names)),
    )
}

/// MakeHuman 1 asks for one joint; it ignores others that are unknown.
fn foreign(file: &FileFacts, motion: &Motion) -> Option<Finding> {
    let is_read = motion
        .fault
        .as_ref()
        .is_none_or(|fault| fault.kind.is_of_frames());
    let first = motion.joints.first().filter(|_| is_read)?;
    let has_it = motion.joints.iter().any(|joint| &*joint.name == COMPARED);
    let message = format!("no joint is called `{COMPARED}`: the pose is for another rig");
    let finding = RULE
        .at(file, Place::Span(first.span.clone()), message)
        .key("rig");
    (!has_it).then(|| finding.help("export the motion for the default rig of MakeHuman 1"))
}
