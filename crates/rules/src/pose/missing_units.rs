//! Poses need the units that they are made of.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::{Body, BodyPose, PoseUnitsFile};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "shows a message in place of each of these poses"),
        (Makehuman1, "fails when the expressions are opened: it lists them and shows none"),
    ],
    docs: "A base has poses (`.mhpose`) in `poses/<base>/` but no `base/<base>/body-poses.json`, or expressions in \
        `expressions/<base>/` but no `face-poses.json`. These files say what the units of the poses turn.\n\n\
        Without `body-poses.json` MakeHuman 2 shows a message whenever one of the poses is chosen, and no pose. Without \
        `face-poses.json` expressions silently do nothing (a warning). Motions (`.bvh`) need neither.\n\n\
        MakeHuman 1 makes expressions of the frames of `poseunits/face-poseunits.bvh`, which have their names in \
        `face-poseunits.json` beside it. Without either no expression can be shown.\n\n\
        Add the file, or remove the poses.",
    of_whole: true,
    ..RuleInfo::new("pose-missing-units", Level::Error, "the units that poses are made of do not exist")
});

const EXPRESSIONS: Case = &[(Makehuman2, Level::Warning, "logs a line; the expressions do nothing")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // The system's base may have them; those of the body came in 2025.
    if body.is_open || body.is_before("2025") {
        return;
    }
    let mut told = "";
    for units in body.pose_units.iter().filter(|units| !units.is_there) {
        // Where a folder with both files is missing, that is one fault.
        if std::mem::replace(&mut told, units.category) == units.category {
            continue;
        }
        let is_expression = units.category == "expressions";
        let poses: Vec<&BodyPose<'_>> = body.poses.iter().filter(|pose| pose.is_expression == is_expression).collect();
        let Some(first) = poses.first() else { continue };
        out.push(finding(body, units, poses.len(), first));
    }
}

fn finding(body: &Body<'_>, units: &PoseUnitsFile<'_>, count: usize, first: &BodyPose<'_>) -> Finding {
    let (noun, is_expression) = if first.is_expression { ("expression", true) } else { ("pose", false) };
    let need = if count == 1 { "needs" } else { "need" };
    let message = format!("`{}` does not exist, but {} {need} it", units.rel, counted(count, noun));
    let finding = RULE.in_layer(body.layers.checked, &units.rel, message).key(units.category);
    let finding = finding.related(first.file.path.clone(), mhlint_diag::Place::File, format!("the first {noun}"));
    let finding =
        finding.help("pass the system data with `--system`, or restore the file with the units; keep the poses");
    if is_expression { finding.case(EXPRESSIONS) } else { finding }
}
