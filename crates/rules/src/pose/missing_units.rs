//! Poses need the units that they are made of.

use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level, RuleInfo,
};
use mhlint_repo::{Body, BodyPose, PoseUnitsFile};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows a message in place of each of these poses",
        ),
        (
            Makehuman1,
            "fails when the expressions are opened: it lists them and shows none",
        ),
    ],
    docs: include_str!("missing_units.md").trim_ascii_end(),
    of_whole: true,
    ..RuleInfo::new(
        "pose-missing-units",
        Level::Error,
        "the units that poses are made of do not exist",
    )
});

const EXPRESSIONS: Case = &[(
    Makehuman2,
    Level::Warning,
    "logs a line; the expressions do nothing",
)];

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
        let poses: Vec<&BodyPose<'_>> = body
            .poses
            .iter()
            .filter(|pose| pose.is_expression == is_expression)
            .collect();
        let Some(first) = poses.first() else { continue };
        out.push(finding(body, units, poses.len(), first));
    }
}

fn finding(
    body: &Body<'_>,
    units: &PoseUnitsFile<'_>,
    count: usize,
    first: &BodyPose<'_>,
) -> Finding {
    let (noun, is_expression) = if first.is_expression {
        ("expression", true)
    } else {
        ("pose", false)
    };
    let need = if count == 1 { "needs" } else { "need" };
    let message = format!(
        "`{}` does not exist, but {} {need} it",
        units.rel,
        counted(count, noun)
    );
    let finding = RULE
        .in_layer(body.layers.checked, &units.rel, message)
        .key(units.category);
    let finding = finding.related(
        first.file.path.clone(),
        mhlint_diag::Place::File,
        format!("the first {noun}"),
    );
    let finding = finding.help(
        "pass the system data with `--system`, or restore the file with the units; keep the poses",
    );
    if is_expression {
        finding.case(EXPRESSIONS)
    } else {
        finding
    }
}
