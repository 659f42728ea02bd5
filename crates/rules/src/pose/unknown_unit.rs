//! Poses set units that exist, and units have counterparts that exist.

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::{UNITS, foreign_unit, names};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_repo::{Body, BodyPose};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "silently ignores the unit"),
        (
            Makehuman1,
            "fails with `ValueError` when the expression is chosen",
        ),
    ],
    levels: &[(Makehuman1, Level::Error)],
    docs: include_str!("unknown_unit.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-unknown-unit",
        Level::Warning,
        "a pose sets a unit that does not exist",
    )
});

const NO_MIRROR: Case = &[(
    Makehuman2,
    Level::Warning,
    "does nothing for this unit when a pose is mirrored",
)];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // What several poses have in common is mostly a unit that was renamed.
    let lacking = body
        .poses
        .iter()
        .filter_map(|pose| Some((unknown(body, pose)?, pose)));
    for (units, poses) in grouped(lacking) {
        out.extend(of_poses(body, &units, &poses, cx));
    }
    for (file, units) in body.pose_units.iter().filter_map(|own| own.units) {
        let known = names(units);
        let partners = units
            .units
            .iter()
            .filter_map(|unit| Some((unit, unit.partner.as_ref()?)));
        let lost: Vec<_> = partners
            .filter(|(_, (_, partner))| !known.contains(partner.as_str()))
            .collect();
        let Some((unit, (key, partner))) = lost.first().filter(|_| body.layers.is_checked(file))
        else {
            continue;
        };
        let more = such(lost.len(), "units");
        let message = format!(
            "`{key}` of unit `{}` is `{partner}`, which does not exist{more}",
            unit.name
        );
        let near = cx.suggestions.nearest(partner, known.iter().copied());
        let finding = RULE
            .at(file, Place::pointer([unit.name.as_str(), key]), message)
            .key("partner")
            .case(NO_MIRROR);
        let evidence = Evidence::of_cases(lost.iter().map(|(unit, _)| &unit.name));
        out.push(finding.evidence(evidence).help(did_you_mean(
            near,
            "name a unit of this file, or remove the key",
        )));
    }
}

/// The units of a pose that do not exist; `None` where all do, or nobody can tell.
fn unknown<'v>(body: &Body<'_>, pose: &BodyPose<'v>) -> Option<Vec<&'v str>> {
    let (_, known) = body.unit_names(pose)?;
    let is_known = |unit: &str| known.contains((pose.renewed)(unit).unwrap_or(unit));
    // A bracket that stands elsewhere has a finding of its own (`json-schema`).
    let units = pose.pose.values.iter().filter(|one| !one.is_object);
    let units = units.map(|one| &*one.unit);
    let unknown: Vec<&str> = units.filter(|unit| !is_known(unit)).collect();
    (!unknown.is_empty()).then_some(unknown)
}

/// The finding on poses that set the same units which do not exist.
fn of_poses(
    body: &Body<'_>,
    unknown: &[&str],
    poses: &[&BodyPose<'_>],
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (pose, first) = (poses.first()?, unknown.first()?);
    let (file, known) = body.unit_names(pose)?;
    let (count, all) = (unknown.len(), pose.pose.values.len());
    let more = such(
        poses.len(),
        if pose.is_expression {
            "expressions"
        } else {
            "poses"
        },
    );
    let message = match count {
        1 => format!(
            "unit `{first}` does not exist in `{}`{more}",
            file.file_name()
        ),
        count if count == all => format!(
            "none of the {all} units exists in `{}`, first `{first}`",
            file.file_name()
        ),
        count => format!(
            "{count} of {all} units do not exist in `{}`, first `{first}`{more}",
            file.file_name()
        ),
    };
    let near = cx.suggestions.nearest(first, known.iter().copied());
    let help = foreign_unit::help(body, pose, first).unwrap_or_else(|| {
        did_you_mean(
            near,
            format!("use a unit of `{}`, or remove it", file.file_name()),
        )
    });
    let finding = RULE
        .at(pose.file, Place::pointer([UNITS, first]), message)
        .against(&file.path)
        .help(help);
    if poses.len() < 2 {
        return Some(finding.evidence(Evidence::of_cases(unknown.iter().copied()).out_of(all)));
    }
    let parts = poses.iter().map(|one| {
        (
            one.file.shown(),
            &one.file.path,
            Place::pointer([UNITS, first]),
        )
    });
    let finding = finding.key(*first).parts_at(parts);
    Some(finding.evidence(Evidence::of_cases(poses.iter().map(|one| one.file.shown()))))
}
