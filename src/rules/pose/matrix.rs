//! A pose unit turns a bone by nine numbers.

use super::super::{Check, Rule, RuleCx, such};
use super::{at, turns};
use crate::diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::pose_units::TurnFault;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "crashes at start when it loads the base")],
    docs: "A bone of a unit in `body-poses.json` or `face-poses.json` has another number of values than nine, or one that \
        is not a number. The nine numbers are a rotation matrix, row by row; three lists of three numbers are the \
        same.\n\n\
        MakeHuman 2 reads all units when it loads the base, and crashes at start.\n\n\
        Restore the matrix, or remove the bone from the unit.",
    ..RuleInfo::new("pose-matrix", Level::Error, "the matrix of a pose unit is not nine numbers")
});

fn run(_: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(units) = file.pose_units() else { return };
    let faulty = turns(units).filter_map(|(unit, half, turn)| {
        let fault = turn.fault.as_ref().filter(|fault| **fault != TurnFault::NonFinite)?;
        Some((at(unit, half, turn), unit, turn, fault))
    });
    let faulty: Vec<_> = faulty.collect();
    let Some((place, unit, turn, fault)) = faulty.first() else { return };
    let what = match fault {
        TurnFault::NoList => "is not a list of nine numbers".to_owned(),
        TurnFault::Count(9) => "has a row that does not have 3 numbers".to_owned(),
        TurnFault::Count(count) => format!("has {count} numbers, expected 9"),
        TurnFault::NotANumber | TurnFault::NonFinite => "has a value that is not a number".to_owned(),
    };
    let more = such(faulty.len(), "matrices");
    let message = format!("the matrix of bone `{}` in unit `{}` {what}{more}", turn.bone, unit.name);
    let evidence = Evidence::of_cases(faulty.iter().map(|(place, ..)| place));
    let finding = RULE.at(file, Place::Pointer(place.clone()), message).evidence(evidence);
    out.push(finding.help("write nine numbers, row by row, or remove the bone from the unit"));
}
