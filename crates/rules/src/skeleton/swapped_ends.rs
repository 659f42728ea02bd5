//! A bone begins where its parent ends.

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::measured::{Measured, measured};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::rig_measure::BoneMeasure;
use mhlint_eval::vector::distance;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "rotates the bone around its far end: the limb tears off at the joint",
        ),
        (
            Makehuman1,
            "rotates the bone around its far end: the limb tears off at the joint",
        ),
    ],
    docs: include_str!("swapped_ends.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-swapped-ends",
        Level::Warning,
        "head and tail of a bone are swapped",
    )
});

/// Joints nearer than this are one, mesh units.
const ONE_JOINT: f64 = 1e-3;
/// How much farther from the head of the parent than its tail the head must be to lie beyond.
const BEYOND: f64 = 1.05;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(measured(body, measures).iter().filter_map(finding));
}

fn finding(rig: &Measured<'_>) -> Option<Finding> {
    let bones = &rig.measure.bones;
    let mut children: Vec<Vec<&BoneMeasure>> = vec![Vec::new(); bones.len()];
    for bone in bones {
        if let Some(children) = bone.parent.and_then(|parent| children.get_mut(parent)) {
            children.push(bone);
        }
    }
    let swapped = bones
        .iter()
        .zip(&children)
        .filter(|(bone, children)| is_swapped(bones, bone, children));
    let swapped: Vec<&str> = swapped.map(|(bone, _)| bone.name.as_str()).collect();
    let first = swapped.first()?;
    let message = match swapped.len() {
        1 => format!("bone `{first}` ends where its parent ends, and begins beyond it"),
        _ => format!(
            "{} end where their parents end, and begin beyond them",
            bones_in_words(&swapped)
        ),
    };
    Some(
        RULE.at(rig.file, Place::pointer(["bones", first]), message)
            .confidence(Confidence::Medium)
            .help("swap `head` and `tail`")
            .evidence(Evidence::of_cases(&swapped).out_of(rig.skeleton.bones.len())),
    )
}

fn is_swapped(bones: &[BoneMeasure], bone: &BoneMeasure, children: &[&BoneMeasure]) -> bool {
    let Some(parent) = bone.parent.and_then(|parent| bones.get(parent)) else {
        return false;
    };
    let is_beyond = distance(bone.head, parent.head) > BEYOND * parent.length;
    distance(bone.tail, parent.tail) < ONE_JOINT
        && bone.length > ONE_JOINT
        && parent.length > ONE_JOINT
        && is_beyond
        && !children
            .iter()
            .any(|child| distance(child.head, bone.tail) < ONE_JOINT)
}
