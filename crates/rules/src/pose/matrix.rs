//! A pose unit turns a bone by nine numbers.

use super::super::{Check, Rule, RuleCx, such};
use super::{at, turns};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::pose_units::{PoseUnits, TurnFault};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes at start when it loads the base")],
    docs: include_str!("matrix.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-matrix",
        Level::Error,
        "the matrix of a pose unit is not nine numbers, or not a rotation",
    )
});

/// Above this it is not the rounding of a few decimals: angles are wrong by about half of it, in
/// radians.
const OFF: f64 = 0.01;

const NO_ROTATION: Case = &[(
    Makehuman2,
    Level::Warning,
    "turns the bone to another direction than the matrix has with every pose that uses the unit",
)];

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(units) = file.pose_units() else {
        return;
    };
    out.extend(no_rotation(units, file));
    let faulty = turns(units).filter_map(|(unit, half, turn)| {
        let fault = turn
            .fault
            .as_ref()
            .filter(|fault| **fault != TurnFault::NonFinite)?;
        Some((at(unit, half, turn), unit, turn, fault))
    });
    let faulty: Vec<_> = faulty.collect();
    let Some((place, unit, turn, fault)) = faulty.first() else {
        return;
    };
    let what = match fault {
        TurnFault::NoList => "is not a list of nine numbers".to_owned(),
        TurnFault::Count(9) => "has a row that does not have 3 numbers".to_owned(),
        TurnFault::Count(count) => format!("has {count} numbers, expected 9"),
        TurnFault::NotANumber | TurnFault::NonFinite => {
            "has a value that is not a number".to_owned()
        }
    };
    let more = such(faulty.len(), "matrices");
    let message = format!(
        "the matrix of bone `{}` in unit `{}` {what}{more}",
        turn.bone, unit.name
    );
    let evidence = Evidence::of_cases(faulty.iter().map(|(place, ..)| place));
    let finding = RULE
        .at(file, Place::Pointer(place.clone()), message)
        .evidence(evidence);
    out.push(finding.help("write nine numbers, row by row, or remove the bone from the unit"));
}

fn no_rotation(units: &PoseUnits, file: &FileFacts) -> Option<Finding> {
    let bent: Vec<_> = turns(units)
        .filter(|(.., turn)| turn.bend.off > OFF || turn.bend.mirrors)
        .collect();
    let places: Vec<String> = bent
        .iter()
        .map(|(unit, half, turn)| at(unit, half, turn))
        .collect();
    let (unit, half, turn) = bent.first()?;
    let what = match turn.bend.off {
        off if off > OFF => format!("is not a rotation: off by {off:.3}"),
        _ => "is a mirror image, not a rotation".to_owned(),
    };
    let half = if *half == "reverse" {
        "the reverse of "
    } else {
        ""
    };
    let more = such(bent.len(), "matrices");
    let message = format!(
        "the matrix of bone `{}` in {half}unit `{}` {what}{more}",
        turn.bone, unit.name
    );
    let finding = RULE
        .at(file, Place::Pointer(places.first()?.clone()), message)
        .key("rotation")
        .case(NO_ROTATION);
    let finding = finding.evidence(Evidence::of_cases(&places));
    Some(finding.help(
        "export the unit again, or write a rotation: rows of length 1 at right \
        angles to each other",
    ))
}
