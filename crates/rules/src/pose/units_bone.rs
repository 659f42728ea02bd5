//! Bones of pose units that the skeleton does not have.

use std::collections::BTreeSet;

use super::super::{Rule, RuleCx, did_you_mean};
use super::{at, turns};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place};
use mhlint_formats::pose_units::PoseUnits;
use mhlint_repo::{FileFacts, Rig};

const MASKED: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `KeyError` as soon as any pose or expression of the base is shown",
)];
const REVERSED: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `KeyError` when the unit is set to a negative value",
)];

/// A finding on all such bones of a file: those of `bones` are asked for with every pose.
pub(super) fn finding(
    rule: &Rule,
    (file, units): (&FileFacts, &PoseUnits),
    rig: &Rig<'_>,
    bones: &BTreeSet<&str>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let unknown: Vec<_> = turns(units)
        .filter(|(.., turn)| !bones.contains(turn.bone.as_str()))
        .collect();
    let masked = unknown.iter().find(|(_, half, _)| *half == "bones");
    let (unit, half, turn) = masked.or(unknown.first())?;
    let names: BTreeSet<&str> = unknown
        .iter()
        .map(|(.., turn)| turn.bone.as_str())
        .collect();
    let skeleton = rig.file.file_name();
    let message = match names.len() {
        1 => format!(
            "bone `{}` of unit `{}` is not in `{skeleton}`",
            turn.bone, unit.name
        ),
        count => format!(
            "{count} bones of units are not in `{skeleton}`, first `{}` of `{}`",
            turn.bone, unit.name
        ),
    };
    let near = cx.suggestions.nearest(&turn.bone, bones.iter().copied());
    let finding = rule
        .at(file, Place::Key(at(unit, half, turn)), message)
        .against(&rig.file.path)
        .key("units");
    let finding = finding.case(if masked.is_some() { MASKED } else { REVERSED });
    let help = did_you_mean(
        near,
        "name a bone of the skeleton, or remove it from the unit",
    );
    Some(finding.evidence(Evidence::of_cases(names)).help(help))
}
