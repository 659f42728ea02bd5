//! Bones lie on the side that their names say.

use super::super::{Check, Rule, RuleCx};
use super::measured::{Measured, measured, named};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::rig_measure::BoneMeasure;
use crate::eval::side::{self, Side};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "poses the skin of one side around joints of the other: the smallest bend throws it far",
        )],
        docs: "A bone whose name says left or right (`hand.L`, `r-thigh`, `LeftFoot` …) has both of its joints on the other half of \
            the body. Left is where x is above 0; joints within 0.1 units of the middle are not counted.\n\nMakeHuman 2 takes the \
            joints as they are and says nothing. The weights stay where the mesh is, so that the skin turns around a joint on \
            the other side of the body, and poses that are mirrored by name move the wrong limb.\n\nMostly left and right were \
            exchanged in `joints`, or a bone names the joints of its partner.",
        ..RuleInfo::new("skeleton-wrong-side", Level::Warning, "a bone lies on the other side than its name says")
    },
    check: Check::Numeric(run),
};

/// More bones than this are not all on the wrong side by mistake.
const MIRRORED: usize = 3;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(measured(body, measures).iter().filter(|rig| rig.measure.is_centred).filter_map(finding));
}

fn finding(rig: &Measured<'_>) -> Option<Finding> {
    let across: Vec<(&str, &BoneMeasure)> = rig
        .bones()
        .map(|(bone, measure)| (bone.name.as_str(), measure))
        .filter(|(name, at)| is_across(name, at))
        .collect();
    let bones: Vec<&str> = across.iter().map(|(name, _)| *name).collect();
    let (first, measure) = across.first()?;
    let lie = if bones.len() == 1 { "lies" } else { "lie" };
    let message = format!(
        "{} {lie} on the other side than named: `{first}` at x = {:.2}",
        named(&bones),
        f32::midpoint(measure.head[0], measure.tail[0])
    );
    let sided = rig.bones().filter(|(bone, _)| side::of_bone(&bone.name).is_some()).count();
    let help = if bones.len() == sided && sided > MIRRORED {
        "all of them: was base.obj mirrored when it was exported?"
    } else {
        "exchange the joints of left and right, or name those of this side in `head` and `tail`"
    };
    Some(
        RULE.at(rig.file, Place::key(["bones", first]), message)
            .help(help)
            .evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len())),
    )
}

fn is_across(name: &str, bone: &BoneMeasure) -> bool {
    let wrong = side::of_bone(name).map(|(side, _)| side.other());
    wrong.is_some() && [bone.head, bone.tail].iter().all(|joint| Side::at(joint[0]) == wrong)
}
