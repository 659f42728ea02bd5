//! The values of a pose are within what its units do.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, such};
use super::UNITS;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhpose::UnitValue;
use mhlint_formats::pose_units::Unit;
use mhlint_repo::{Body, BodyPose};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "turns the bones of the unit further than it is made for",
        ),
        (
            Makehuman1,
            "turns the bones of the unit further than it is made for",
        ),
    ],
    docs: include_str!("value_range.md").trim_ascii_end(),
    ..RuleInfo::new(
        "pose-value-range",
        Level::Warning,
        "a pose sets a unit to a value that it does not have",
    )
});

const NO_EFFECT: Case = &[(
    Makehuman2,
    Level::Warning,
    "silently ignores the value: the unit has no such side",
)];

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fault {
    TooFar,
    NoReverse,
    NoBones,
}

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut known: BTreeMap<bool, BTreeMap<&str, &Unit>> = BTreeMap::new();
    for pose in &body.poses {
        if body.is_makehuman1() {
            out.extend(of_frames(body, pose));
            continue;
        }
        let Some((file, units)) = body.units_of(pose) else {
            continue;
        };
        let by_name = known.entry(pose.is_expression).or_insert_with(|| {
            let units = units.units.iter();
            units.map(|unit| (unit.name.as_str(), unit)).collect()
        });
        let values = pose.pose.values.iter();
        let unit = |one: &UnitValue| {
            by_name
                .get((pose.renewed)(&one.unit).unwrap_or(&one.unit))
                .copied()
        };
        let faulty = grouped(values.filter_map(|one| Some((fault(one, unit(one)?)?, one))));
        out.extend(
            faulty
                .into_iter()
                .filter_map(|(fault, all)| finding(pose, &file.path, fault, &all)),
        );
    }
}

fn fault(one: &UnitValue, unit: &Unit) -> Option<Fault> {
    let value = one.value.filter(|value| value.is_finite())?;
    // A unit that turns nothing at all is one for the position, or a deliberate nothing.
    if unit.bones.is_none() && unit.reverse.is_none() {
        return None;
    }
    match value {
        value if value < 0.0 && unit.reverse.is_none() => Some(Fault::NoReverse),
        value if value > 0.0 && unit.bones.is_none() => Some(Fault::NoBones),
        value if value.abs() > 1.0 => Some(Fault::TooFar),
        _ => None,
    }
}

/// Of frames a value is the way from the rest pose, which may lead to the other side.
fn of_frames(body: &Body<'_>, pose: &BodyPose<'_>) -> Option<Finding> {
    let (file, known) = body.unit_names(pose)?;
    let is_too_far = |one: &&UnitValue| {
        let value = one.value.filter(|value| value.is_finite());
        known.contains(&*one.unit) && value.is_some_and(|value| value.abs() > 1.0)
    };
    let far: Vec<&UnitValue> = pose.pose.values.iter().filter(is_too_far).collect();
    finding(pose, &file.path, Fault::TooFar, &far)
}

fn finding(pose: &BodyPose<'_>, units: &str, fault: Fault, all: &[&UnitValue]) -> Option<Finding> {
    let first = all.first()?;
    let (unit, value) = (&first.unit, first.value?);
    let (what, help, key) = match fault {
        Fault::TooFar if value.abs() >= 5.0 => (
            "outside -1 to 1",
            format!("write {}", value / 100.0),
            "range",
        ),
        Fault::TooFar => (
            "outside -1 to 1",
            "write a value from -1 to 1".to_owned(),
            "range",
        ),
        Fault::NoReverse => (
            "but it has no `reverse`",
            "write a positive value, or add `reverse` to the unit".to_owned(),
            "reverse",
        ),
        Fault::NoBones => (
            "but it has no `bones`",
            "write a negative value, or add `bones` to the unit".to_owned(),
            "bones",
        ),
    };
    let more = such(all.len(), "values");
    let message = format!("unit `{unit}` is set to {value}, {what}{more}");
    let finding = RULE
        .at(pose.file, Place::pointer([UNITS, unit]), message)
        .key(key)
        .against(units)
        .help(help);
    let finding = finding.evidence(Evidence::of_cases(all.iter().map(|one| &one.unit)));
    Some(if fault == Fault::TooFar {
        finding
    } else {
        finding.case(NO_EFFECT)
    })
}
