//! Joints of motions that Blender imports are bones of the default rigs
//! (`docs/loaders/mpfb/poses.md#motions`).

use std::collections::BTreeSet;

use super::super::{Rule, RuleCx, did_you_mean};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_formats::bvh::blender::ImportedMotion;
use mhlint_formats::rig::Rig;
use mhlint_repo::{Body, FileFacts};

const NOTHING: Case = &[(
    Mpfb,
    Level::Warning,
    "changes nothing: no joint is a bone of a default rig",
)];

/// Joints that no default rig has: the library offers motions for these rigs alone.
pub(super) fn findings(rule: &Rule, body: &Body<'_>, cx: &RuleCx<'_>) -> Vec<Finding> {
    let Some((file, bones)) = default_bones(body) else {
        return Vec::new();
    };
    let read = body
        .imported_motions
        .iter()
        .filter(|(_, motion)| motion.fault.is_none());
    read.filter_map(|(motion_file, motion)| finding(rule, motion_file, motion, file, &bones, cx))
        .collect()
}

/// The bones of all default rigs, with the first of these; `None` where one of them cannot be read.
fn default_bones<'v>(body: &Body<'v>) -> Option<(&'v FileFacts, BTreeSet<&'v str>)> {
    let is_default = |file: &FileFacts| {
        file.stem()
            .strip_prefix("rig.")
            .is_some_and(|name| name.contains("default"))
    };
    let files: Vec<&FileFacts> = body
        .rigs
        .iter()
        .map(|rig| rig.file)
        .filter(|file| is_default(file))
        .collect();
    let rigs: Option<Vec<&Rig>> = files.iter().map(|file| file.rig()).collect();
    let bones: BTreeSet<&str> = rigs?
        .into_iter()
        .flat_map(|rig| rig.bones.iter().map(|bone| bone.name.as_str()))
        .collect();
    let first = files.first().copied().filter(|_| !bones.is_empty())?;
    Some((first, bones))
}

fn finding(
    rule: &Rule,
    file: &FileFacts,
    motion: &ImportedMotion,
    rig: &FileFacts,
    bones: &BTreeSet<&str>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let unknown: Vec<_> = motion
        .joints
        .iter()
        .filter(|joint| !bones.contains(&*joint.name))
        .collect();
    let first = unknown.first()?;
    let (count, all) = (unknown.len(), motion.joints.len());
    let message = match count {
        _ if count == all => format!(
            "none of the {all} joints is a bone of a default rig, first `{}`",
            first.name
        ),
        1 => format!("joint `{}` is not a bone of a default rig", first.name),
        _ => format!(
            "{count} of {all} joints are not bones of a default rig, first `{}`",
            first.name
        ),
    };
    let near = cx
        .suggestions
        .nearest(&first.name, bones.iter().copied())
        .filter(|_| count < all);
    let help = did_you_mean(
        near,
        "export the motion for the rig `default`, or rename the joints",
    );
    let finding = rule
        .at(file, Place::Span(first.span.clone()), message)
        .against(&rig.path)
        .help(help);
    let finding = finding.evidence(
        Evidence::of_cases(unknown.iter().map(|joint| joint.name.to_string())).out_of(all),
    );
    Some(if count == all {
        finding.case(NOTHING)
    } else {
        finding
    })
}
