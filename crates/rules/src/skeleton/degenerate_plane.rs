//! Three joints of a rotation plane span a plane.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::measured::{Measured, measured, plane_of};
use mhlint_diag::{
    Application::Makehuman2, Case, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_eval::skeleton::PARALLEL_SINE;
use mhlint_formats::mhskel::Plane;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "gets no normal: in pose mode all vertices of the bones that use the plane, and of those \
            below them, disappear",
    )],
    docs: include_str!("degenerate_plane.md").trim_ascii_end(),
    counts: "bones",
    grows: Grows::less(MeasureKind::Sine),
    ..RuleInfo::new(
        "skeleton-degenerate-plane",
        Level::Error,
        "the joints of a rotation plane are on one straight line",
    )
});

const NOISE: Case = &[(
    Makehuman2,
    Level::Warning,
    "takes the roll of the bones that use the plane from rounding errors, so it differs between \
        characters",
)];

/// Sine of the angle between the edges below which rounding of joints decides the normal.
const NOISE_SINE: f64 = 1e-4;

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in measured(body, measures) {
        let mut planes: BTreeMap<&str, (f64, Vec<&str>)> = BTreeMap::new();
        for (bone, measure) in rig.bones() {
            let flat = measure
                .plane_sine
                .filter(|sine| !sine.is_finite() || *sine < NOISE_SINE);
            if let Some((sine, plane)) = flat.zip(plane_of(bone)) {
                planes
                    .entry(plane)
                    .or_insert((sine, Vec::new()))
                    .1
                    .push(&bone.name);
            }
        }
        // Of equal names the first.
        let known: BTreeMap<&str, &Plane> = rig
            .skeleton
            .planes
            .iter()
            .rev()
            .map(|plane| (plane.name.as_str(), plane))
            .collect();
        let collapsed = if planes.is_empty() {
            BTreeSet::new()
        } else {
            rig.collapsed().into_iter().collect()
        };
        let joints = |plane: &str| {
            Some(
                known
                    .get(plane)?
                    .joints
                    .as_deref()?
                    .iter()
                    .take(3)
                    .filter_map(Option::as_deref),
            )
        };
        out.extend(planes.iter().filter_map(|(plane, (sine, bones))| {
            let joints: Vec<&str> = joints(plane)?.collect();
            // Joints that coincide because a bone between them has no length: the bone is named for
            // it.
            let is_bone = |head: &&str| {
                joints
                    .iter()
                    .any(|tail| collapsed.contains(&(*head, *tail)))
            };
            (!joints.iter().any(is_bone)).then(|| finding(&rig, plane, &joints, *sine, bones))
        }));
    }
}

fn finding(rig: &Measured<'_>, plane: &str, joints: &[&str], sine: f64, bones: &[&str]) -> Finding {
    let list = joints
        .iter()
        .map(|joint| format!("`{joint}`"))
        .collect::<Vec<_>>()
        .join(", ");
    let why = match sine {
        sine if !sine.is_finite() => format!("has no normal: two of its joints {list} coincide"),
        sine if sine < PARALLEL_SINE => {
            format!("has no normal: its joints {list} are on one straight line")
        }
        sine => {
            let angle = sine.asin().to_degrees();
            format!(
                "has an unreliable normal: its joints {list} are only {angle:.6}° off one \
                    straight line"
            )
        }
    };
    let message = format!("plane `{plane}` {why}");
    let evidence = Evidence::of_cases(bones)
        .out_of(rig.skeleton.bones.len())
        .with_worst(sine, plane);
    let finding = RULE
        .at(rig.file, Place::pointer(["planes", plane]), message)
        .key(plane)
        .help("choose three joints that form a triangle")
        .evidence(evidence);
    let is_noise = sine.is_finite() && sine >= PARALLEL_SINE;
    if is_noise {
        finding.case(NOISE)
    } else {
        finding
    }
}
