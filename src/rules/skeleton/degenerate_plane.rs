//! Three joints of a rotation plane span a plane.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::measured::{Measured, measured, named, plane_of};
use crate::diag::{Application, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::eval::measures::Measures;
use crate::eval::skeleton::PARALLEL_SINE;
use crate::formats::mhskel::Plane;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "has no number for the normal: in pose mode every vertex of the bone and of those below it is gone",
        )],
        docs: "The three joints of a `rotation_plane` lie on one line, or two of them at one place, on the default \
            character.\n\nThe plane gives the roll of its bones. Without an area it has no normal, and the rest matrices of the \
            bones are not numbers; the program says nothing. Where the joints are on a line but for rounding (a sine below \
            0.0001) there is a normal, but it is noise: a warning.\n\nTake three joints that make a triangle, such as shoulder, \
            elbow and wrist of a bent arm.",
        ..RuleInfo::new("skeleton-degenerate-plane", Level::Error, "the joints of a rotation plane are on one line")
    },
    check: Check::Numeric(run),
};

const NOISE: Case =
    &[(Application::Makehuman2, Level::Warning, "rolls the bones by rounding errors, differently for every character")];

/// Sine of the angle between the edges below which rounding of joints decides the normal.
const NOISE_SINE: f64 = 1e-4;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in measured(body, measures) {
        let mut planes: BTreeMap<&str, (f64, Vec<&str>)> = BTreeMap::new();
        for (bone, measure) in rig.bones() {
            let flat = measure.plane_sine.filter(|sine| !sine.is_finite() || *sine < NOISE_SINE);
            if let Some((sine, plane)) = flat.zip(plane_of(bone)) {
                planes.entry(plane).or_insert((sine, Vec::new())).1.push(&bone.name);
            }
        }
        // Of equal names the first.
        let known: BTreeMap<&str, &Plane> =
            rig.skeleton.planes.iter().rev().map(|plane| (plane.name.as_str(), plane)).collect();
        let collapsed = if planes.is_empty() { BTreeSet::new() } else { rig.collapsed().into_iter().collect() };
        let joints =
            |plane: &str| Some(known.get(plane)?.joints.as_deref()?.iter().take(3).filter_map(Option::as_deref));
        out.extend(planes.iter().filter_map(|(plane, (sine, bones))| {
            let joints: Vec<&str> = joints(plane)?.collect();
            // Joints that coincide because a bone between them has no length: the bone is named for it.
            let is_bone = |head: &&str| joints.iter().any(|tail| collapsed.contains(&(*head, *tail)));
            (!joints.iter().any(is_bone)).then(|| finding(&rig, plane, &joints, *sine, bones))
        }));
    }
}

fn finding(rig: &Measured<'_>, plane: &str, joints: &[&str], sine: f64, bones: &[&str]) -> Finding {
    let list = joints.iter().map(|joint| format!("`{joint}`")).collect::<Vec<_>>().join(", ");
    let how = match sine {
        sine if !sine.is_finite() => "two of them coincide".to_owned(),
        sine if sine < PARALLEL_SINE => "they are on one line".to_owned(),
        sine => format!("they are on one line but for a sine of {sine:.1e}"),
    };
    let message = format!("plane `{plane}` of {} has no normal: its joints are {list}, and {how}", named(bones));
    let evidence = Evidence::of_cases(bones).out_of(rig.skeleton.bones.len()).with_worst(sine, plane);
    let finding = RULE
        .at(rig.file, Place::pointer(["planes", plane]), message)
        .key(plane)
        .help("take three joints that make a triangle")
        .evidence(evidence);
    let is_noise = sine.is_finite() && sine >= PARALLEL_SINE;
    if is_noise { finding.case(NOISE) } else { finding }
}
