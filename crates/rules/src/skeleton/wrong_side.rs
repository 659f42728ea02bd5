//! Bones lie on the side that their names say.

use super::super::units::centimetres;
use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::measured::{Measured, measured};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::rig_measure::BoneMeasure;
use mhlint_eval::side::{self, Side};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rotates the skin around joints of its left/right counterpart: the smallest bend \
                throws it far off",
        ),
        (
            Makehuman1,
            "rotates the skin around joints of its left/right counterpart: the smallest bend \
                throws it far off",
        ),
    ],
    docs: include_str!("wrong_side.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-wrong-side",
        Level::Warning,
        "a bone is not on the side its name \
        says",
    )
});

/// More bones than this are not all on the wrong side by mistake.
const MIRRORED: usize = 3;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(
        measured(body, measures)
            .iter()
            .filter(|rig| rig.measure.is_centred)
            .filter_map(finding),
    );
}

fn finding(rig: &Measured<'_>) -> Option<Finding> {
    let across: Vec<(&str, &BoneMeasure)> = rig
        .bones()
        .map(|(bone, measure)| (bone.name.as_str(), measure))
        .filter(|(name, at)| is_across(name, at))
        .collect();
    let bones: Vec<&str> = across.iter().map(|(name, _)| *name).collect();
    let (first, measure) = across.first()?;
    let x = f32::midpoint(measure.head[0], measure.tail[0]);
    let is_not = if bones.len() == 1 {
        "is not on the side its name says"
    } else {
        "are not on the side their names say"
    };
    let message = format!(
        "{} {is_not}: `{first}` is at x = {:.1} cm ({x:.2})",
        bones_in_words(&bones),
        centimetres(x)
    );
    let sided = rig
        .bones()
        .filter(|(bone, _)| side::of_bone(&bone.name).is_some())
        .count();
    let help = if bones.len() == sided && sided > MIRRORED {
        "check whether base.obj was mirrored when it was exported: every left or right bone is \
            wrong"
    } else {
        "swap the left and right joints, or name the joints of the correct side in `head` and \
            `tail`"
    };
    Some(
        RULE.at(rig.file, Place::key(["bones", first]), message)
            .help(help)
            .evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len())),
    )
}

fn is_across(name: &str, bone: &BoneMeasure) -> bool {
    let wrong = side::of_bone(name).map(|(side, _)| side.other());
    wrong.is_some()
        && [bone.head, bone.tail]
            .iter()
            .all(|joint| Side::at(joint[0]) == wrong)
}
