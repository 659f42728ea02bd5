//! Head and tail of a bone are two places.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::joint_or_group::joints_of_mesh;
use super::measured::{Measured, NO_LENGTH, measured};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Grows, Level, MeasureKind, Place, RuleInfo, grouped,
};
use mhlint_eval::measures::Measures;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "silently divides by zero: in pose mode all vertices of the bone and of the bones \
                below it disappear",
        ),
        (
            Makehuman1,
            "fails with `LinAlgError` when the skeleton is chosen",
        ),
    ],
    docs: include_str!("zero_length_bone.md").trim_ascii_end(),
    counts: "bones",
    grows: Grows::less(MeasureKind::Length),
    ..RuleInfo::new(
        "skeleton-zero-length-bone",
        Level::Error,
        "head and tail of a bone coincide",
    )
});

const OF_LEAF: Case = &[(Makehuman1, Level::Info, "loads it: no bone hangs below it")];

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let of_mesh = joints_of_mesh(body);
    for rig in measured(body, measures) {
        let joints = rig.skeleton.joints.iter();
        let filled = joints.filter(|joint| joint.listed > 0);
        let own: BTreeSet<&str> = filled.map(|joint| joint.name.as_str()).collect();
        // Ends that are nowhere are told themselves, and so is a mesh without joints.
        let is_placed = |end: &Option<String>| {
            let is_at = |name: &str| own.contains(name) || of_mesh.contains(name);
            !body.is_makehuman1() || end.as_deref().is_some_and(is_at)
        };
        let short = rig
            .bones()
            .filter(|(_, measure)| measure.length < NO_LENGTH);
        let short = short.filter(|(bone, _)| is_placed(&bone.head) && is_placed(&bone.tail));
        let ends = grouped(short.filter_map(|(bone, measure)| {
            Some((
                (bone.head.as_deref()?, bone.tail.as_deref()?),
                (bone.name.as_str(), measure.length),
            ))
        }));
        let parents: BTreeSet<&str> = rig
            .skeleton
            .bones
            .iter()
            .filter_map(|bone| bone.parent.as_deref())
            .collect();
        out.extend(
            ends.iter()
                .filter_map(|(ends, bones)| finding(&rig, &parents, *ends, bones)),
        );
    }
}

fn finding(
    rig: &Measured<'_>,
    parents: &BTreeSet<&str>,
    (head, tail): (&str, &str),
    bones: &[(&str, f64)],
) -> Option<Finding> {
    let (first, length) = *bones.first()?;
    let bones: Vec<&str> = bones.iter().map(|(bone, _)| *bone).collect();
    let have = if bones.len() == 1 { "has" } else { "have" };
    let why = if head == tail {
        format!("head and tail are both joint `{head}`")
    } else {
        format!("joints `{head}` and `{tail}` coincide")
    };
    let message = format!("{} {have} no length: {why}", bones_in_words(&bones));
    let evidence = Evidence::of_cases(&bones)
        .out_of(rig.skeleton.bones.len())
        .with_worst(length, first);
    let finding = RULE
        .at(rig.file, Place::key(["bones", first]), message)
        .key(format!("{head}/{tail}"))
        .help("give the bone two joints at different places")
        .evidence(evidence);
    Some(if bones.iter().any(|bone| parents.contains(bone)) {
        finding
    } else {
        finding.case(OF_LEAF)
    })
}
