//! A plane is three joints.

use super::super::{Check, Rule, RuleCx, counted};
use super::{Rig, SINGLE, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::mhskel::Plane;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `TypeError` or `KeyError` when it computes the bones that use the plane",
        ),
        (
            Makehuman1,
            "fails with `ValueError` or `AttributeError` when the skeleton is chosen",
        ),
    ],
    docs: include_str!("malformed_plane.md").trim_ascii_end(),
    counts: "planes",
    ..RuleInfo::new(
        "skeleton-malformed-plane",
        Level::Error,
        "a plane is not a list of three joints",
    )
});

const EXCEPTION: Case = &[(Makehuman2, Level::Error, "crashes")];
const TYPE_ERROR: Case = &[(Makehuman2, Level::Error, "crashes with `TypeError`")];
const KEY_ERROR: Case = &[(Makehuman2, Level::Error, "crashes with `KeyError`")];
const REFUSED: Case = &[(
    Makehuman2,
    Level::Error,
    "rejects the skeleton and logs a line",
)];
const NOT_USED: Case = &[(
    Makehuman2,
    Level::Info,
    "never reads the plane: no bone uses it",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_makehuman1() {
        return of_makehuman1(body, out);
    }
    for rig in rigs(body) {
        let asked = rig.asked_planes();
        let faults = grouped(rig.skeleton.planes.iter().filter_map(|plane| {
            let (what, error) = fault(plane)?;
            let outcome = if asked.contains(plane.name.as_str()) {
                Outcome::Asked(error)
            } else {
                Outcome::NotUsed
            };
            Some(((what, outcome), plane.name.as_str()))
        }));
        for ((what, outcome), planes) in faults.iter() {
            if planes.len() > SINGLE {
                let message = format!(
                    "{} planes are malformed, first: `{}` {what}",
                    planes.len(),
                    name(planes)
                );
                let evidence = Evidence::of_cases(planes).out_of(rig.skeleton.planes.len());
                out.push(
                    finding(&rig, name(planes), *outcome, message)
                        .key(what)
                        .evidence(evidence),
                );
                continue;
            }
            let each = planes
                .iter()
                .map(|plane| finding(&rig, plane, *outcome, format!("plane `{plane}` {what}")));
            out.extend(each);
        }
    }
}

/// What is no list is no plane to it, and three times null is none.
fn of_makehuman1(body: &Body<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body) {
        for plane in rig.skeleton.planes.iter().filter(|plane| !plane.is_null) {
            let Some(joints) = plane.joints.as_deref() else {
                continue;
            };
            let what = match joints.iter().position(Option::is_none) {
                _ if joints.len() != 3 => {
                    format!("has {} instead of 3", counted(joints.len(), "joint"))
                }
                Some(at) => format!("has no joint name at index {at}"),
                None => continue,
            };
            let finding = RULE.at(
                rig.file,
                Place::pointer(["planes", &plane.name]),
                format!("plane `{}` {what}", plane.name),
            );
            out.push(
                finding
                    .key(&plane.name)
                    .help("name three joints, or remove the plane"),
            );
        }
    }
}

/// What becomes of a plane that is malformed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    /// A bone uses it: the exception that follows, if one does.
    Asked(Option<Case>),
    NotUsed,
}

fn name<'p>(planes: &[&'p str]) -> &'p str {
    planes.first().copied().unwrap_or_default()
}

fn finding(rig: &Rig<'_>, plane: &str, outcome: Outcome, message: String) -> Finding {
    let finding = RULE
        .at(rig.file, Place::pointer(["planes", plane]), message)
        .key(plane)
        .help(
            "name three joints that are not on one straight line, or remove the plane and the \
            `rotation_plane` of its bones",
        );
    match outcome {
        Outcome::NotUsed => finding.case(NOT_USED),
        Outcome::Asked(Some(exceptions)) => rig.stops_with(exceptions, finding),
        Outcome::Asked(None) => finding.case(REFUSED),
    }
}

/// What is wrong with a plane, and the exception that follows, if one does.
fn fault(plane: &Plane) -> Option<(String, Option<Case>)> {
    let Some(joints) = plane.joints.as_deref() else {
        return Some(("is not a list of joints".to_owned(), Some(EXCEPTION)));
    };
    if plane.is_null {
        return Some(("is `[null, null, null]`".to_owned(), None));
    }
    if joints.len() < 3 {
        return Some((
            format!("has {} instead of 3", counted(joints.len(), "joint")),
            Some(TYPE_ERROR),
        ));
    }
    let unnamed = joints.iter().take(3).position(Option::is_none)?;
    Some((
        format!("has no joint name at index {unnamed}"),
        Some(KEY_ERROR),
    ))
}
