//! The vertices at which bones end are counted from 0, not from 1.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::located::{Figure, apart, end, relative_scale};
use super::{at_bones, pairs};
use mhlint_diag::{Application::Mpfb, Confidence, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::joints::Joints;
use mhlint_eval::vector::Vec3;
use mhlint_formats::rig::{End, Rig, RigBone, Strategy};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "puts the ends on the neighbours of the vertices that were meant",
    )],
    docs: include_str!("renumbered.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-renumbered",
        Level::Warning,
        "vertices of a rig are counted from 1",
    )
});

/// Two ends are symmetric if the mirror image of the one is nearer than this to the other, in
/// metres.
const NEAR: f64 = 2e-3;
/// With at least this many ends the symmetry is no accident.
const FEW: usize = 3;

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(figure) = Figure::of(view) else {
        return;
    };
    let joints = figure.joints();
    for (file, rig) in view
        .own_rigs()
        .filter(|(file, _)| file.part != RigPart::Asset)
    {
        out.extend(finding(file, rig, &joints));
    }
}

/// The strategies that name vertices. They are looked at one by one, since an exporter may count
/// wrongly in one of them alone.
const OF_VERTICES: [fn(&End) -> bool; 2] = [
    |end| matches!(end.strategy, Strategy::Vertex(_)),
    |end| matches!(end.strategy, Strategy::Mean(_)),
];

fn finding(file: &RigFile<'_>, rig: &Rig, joints: &Joints<'_>) -> Option<Finding> {
    let mut meant: Vec<&str> = OF_VERTICES
        .iter()
        .flat_map(|is_one| off_by_one(rig, joints, *is_one))
        .collect();
    let message = format!(
        "the vertices of {} ends are one too large: counted from 1",
        meant.len()
    );
    meant.sort_unstable();
    meant.dedup();
    let finding = at_bones(&RULE, file, rig, &meant, "", message)?;
    Some(
        finding
            .confidence(Confidence::Medium)
            .help("subtract 1 from these vertices of the rig"),
    )
}

/// The bones with ends of one strategy that are symmetric only if 1 is subtracted from their
/// vertices. Empty if there are few of these ends, or if too many others are symmetric as they are
/// written.
fn off_by_one<'r>(rig: &'r Rig, joints: &Joints<'_>, is_one: fn(&End) -> bool) -> Vec<&'r str> {
    let scale = relative_scale(rig);
    let bones: BTreeMap<&str, &RigBone> = rig
        .bones
        .iter()
        .map(|bone| (bone.name.as_str(), bone))
        .collect();
    let (mut meant, mut sound) = (Vec::new(), 0);
    for bone in &rig.bones {
        let partner =
            pairs::of(&bone.name).map(|(_, partner)| bones.get(partner.as_str()).copied());
        for which in [
            |bone: &RigBone| bone.head.clone(),
            |bone: &RigBone| bone.tail.clone(),
        ] {
            let Some(own) = which(bone).filter(is_one) else {
                continue;
            };
            let other = match partner {
                None => Some(own.clone()),
                Some(partner) => partner.and_then(which),
            };
            let Some(other) = other else { continue };
            let is_symmetric = |by: i64| {
                let [own, other] =
                    [&own, &other].map(|one| joints.locate(&end(&moved(one, by)), scale).place());
                own.zip(other)
                    .is_some_and(|(own, other)| apart(mirrored(own), other) < NEAR)
            };
            match (is_symmetric(0), is_symmetric(-1)) {
                (true, false) => sound += 1,
                (false, true) => meant.push(bone.name.as_str()),
                _ => {}
            }
        }
    }
    if meant.len() < FEW || sound * 4 > meant.len() {
        Vec::new()
    } else {
        meant
    }
}

fn moved(end: &End, by: i64) -> End {
    let strategy = match &end.strategy {
        Strategy::Vertex(vertex) => Strategy::Vertex(vertex.saturating_add(by)),
        Strategy::Mean(vertices) => Strategy::Mean(
            vertices
                .iter()
                .map(|vertex| vertex.saturating_add(by))
                .collect(),
        ),
        other => other.clone(),
    };
    End {
        strategy,
        ..end.clone()
    }
}

fn mirrored(place: Vec3) -> Vec3 {
    [-place[0], place[1], place[2]]
}
