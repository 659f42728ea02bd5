//! The roll of a bone is an angle in radians, or the bone has the direction that it is aligned to.

use std::f64::consts::TAU;

use super::super::units::short;
use super::super::{Check, Rule, RuleCx, such};
use super::at_bones;
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::rest::NO_LENGTH;
use mhlint_eval::vector::length;
use mhlint_formats::rig::{Rig, RigBone};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "takes the number as radians: the bone is turned about itself otherwise than it was meant",
    )],
    docs: include_str!("roll.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-roll",
        Level::Warning,
        "a roll that is not in radians, or not aligned to anything",
    )
});

const NOT_A_NUMBER: Case = &[(
    Mpfb,
    Level::Warning,
    "makes a bone whose axes are not numbers",
)];
const UNALIGNED: Case = &[(Mpfb, Level::Warning, "silently keeps the number of `roll`")];

const REFERENCE: &str = "ALIGN_Z_REFERENCE_Z";

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for (file, rig) in view.own_rigs() {
        out.extend(finding(file, rig, in_degrees(rig), "roll", |bone| {
            (
                format!(
                    "roll {} of bone `{}` is more than a whole turn in radians",
                    short(bone.roll),
                    bone.name
                ),
                None,
            )
        }));
        out.extend(finding(
            file,
            rig,
            rig.bones.iter().filter(|bone| bone.roll.is_nan()).collect(),
            "roll",
            |bone| {
                (
                    format!("roll of bone `{}` is NaN", bone.name),
                    Some(NOT_A_NUMBER),
                )
            },
        ));
        let has_none = |bone: &&RigBone| {
            let reference = bone
                .roll_reference_z
                .filter(|reference| length(*reference) > NO_LENGTH);
            bone.roll_strategy.as_deref() == Some(REFERENCE) && reference.is_none()
        };
        out.extend(finding(
            file,
            rig,
            rig.bones.iter().filter(has_none).collect(),
            "roll_strategy",
            |bone| {
                let what = "has no direction of three numbers in `roll_reference_z`";
                (
                    format!("{REFERENCE} of bone `{}` {what}", bone.name),
                    Some(UNALIGNED),
                )
            },
        ));
    }
}

/// Bones turned by more than a whole turn, if one of them is by more than two or by a whole number:
/// Blender wraps no angle, so that a bone turned by hand may have a little more than one.
fn in_degrees(rig: &Rig) -> Vec<&RigBone> {
    let beyond = || rig.bones.iter().filter(|bone| bone.roll.abs() > TAU);
    let is_sure = |bone: &RigBone| bone.roll.abs() > 2.0 * TAU || bone.roll.fract() == 0.0;
    if beyond().any(is_sure) {
        beyond().collect()
    } else {
        Vec::new()
    }
}

fn finding(
    file: &RigFile<'_>,
    rig: &Rig,
    found: Vec<&RigBone>,
    key: &'static str,
    words: impl Fn(&RigBone) -> (String, Option<Case>),
) -> Option<Finding> {
    let (message, case) = words(found.first()?);
    let names: Vec<&str> = found.iter().map(|bone| bone.name.as_str()).collect();
    let message = format!("{message}{}", such(found.len(), "bones"));
    let finding = at_bones(&RULE, file, rig, &names, key, message)?;
    let help = match case {
        None => "write the roll in radians: degrees times 0.0174533",
        Some(case) if std::ptr::eq(case, NOT_A_NUMBER) => "write a number",
        Some(_) => "write the direction that z is to have, or the roll itself",
    };
    let finding = finding.key(
        if case.is_some_and(|case| std::ptr::eq(case, NOT_A_NUMBER)) {
            "nan"
        } else {
            key
        },
    );
    Some(
        match case {
            Some(case) => finding.case(case),
            None => finding,
        }
        .help(help),
    )
}
