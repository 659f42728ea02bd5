//! The numbers of a pose must be finite.

use super::super::{Check, Rule, RuleCx, counted};
use super::{UNITS, at, turns};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::pose_units::TurnFault;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows a torn mesh in this pose; the glTF export with animation crashes with \
            `ValueError`",
        ),
        (Makehuman1, "shows a torn mesh in this pose"),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("non_finite.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-non-finite",
        Level::Error,
        "a pose has NaN or infinity",
    )
});

const UNIT: Case = &[(
    Makehuman2,
    Level::Error,
    "shows a torn mesh with every pose that uses the unit; the glTF export with animation crashes \
        with `ValueError`",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    of_motions(body, out);
    for pose in &body.poses {
        // A unit that does not exist is ignored with its value.
        let known = body.unit_names(pose).map(|(_, names)| names);
        let is_used = |unit: &str| {
            known
                .as_ref()
                .is_none_or(|all| all.contains((pose.renewed)(unit).unwrap_or(unit)))
        };
        let bad = pose
            .pose
            .values
            .iter()
            .filter(|one| one.value.is_some_and(|value| !value.is_finite()));
        let bad = bad.filter(|one| is_used(&one.unit));
        let bad: Vec<&str> = bad.map(|one| one.unit.as_str()).collect();
        let Some(first) = bad.first() else { continue };
        let message = format!(
            "the value of unit `{first}` is NaN or infinity{}",
            more(bad.len())
        );
        let finding = RULE
            .at(pose.file, Place::pointer([UNITS, first]), message)
            .evidence(Evidence::of_cases(&bad));
        out.push(finding.help("write a number from -1 to 1"));
    }
    for (file, units) in body.pose_units.iter().filter_map(|own| own.units) {
        let bad = turns(units).filter(|(.., turn)| turn.fault == Some(TurnFault::NonFinite));
        let bad: Vec<_> = bad
            .map(|(unit, half, turn)| (at(unit, half, turn), unit, turn))
            .collect();
        let Some((place, unit, turn)) = bad.first().filter(|_| body.layers.is_checked(file)) else {
            continue;
        };
        let message = format!(
            "the matrix of bone `{}` in unit `{}` has NaN or infinity{}",
            turn.bone,
            unit.name,
            more(bad.len())
        );
        let evidence = Evidence::of_cases(bad.iter().map(|(place, ..)| place));
        let finding = RULE
            .at(file, Place::Pointer(place.clone()), message)
            .case(UNIT)
            .evidence(evidence);
        out.push(finding.help("write nine finite numbers"));
    }
}

fn more(count: usize) -> String {
    if count > 1 {
        format!(" ({count} in all)")
    } else {
        String::new()
    }
}

fn of_motions(body: &Body<'_>, out: &mut Vec<Finding>) {
    for (file, motion) in &body.motions {
        let Some(line) = motion.non_finite.first.first() else {
            continue;
        };
        let message = match motion.non_finite.count {
            1 => "a frame has NaN or infinity".to_owned(),
            count => format!("{} have NaN or infinity", counted(count, "frame")),
        };
        let evidence = motion.non_finite.evidence();
        let finding = RULE
            .at(file, Place::Line(*line), message)
            .evidence(evidence);
        out.push(finding.help("export the motion again, or replace the number"));
    }
}
