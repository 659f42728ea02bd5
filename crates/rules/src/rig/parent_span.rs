//! A constraint of a sub-rig that names two joints of the body means one bone of the body rig.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::located::{Figure, Placed, apart, placed};
use super::{STOPS, at_bones, has_asset, stops};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, RuleInfo};
use mhlint_eval::mpfb::joints::Joints;
use mhlint_eval::vector::Vec3;
use mhlint_formats::rig::{Rig, RigBone, Target};
use mhlint_repo::mpfb::{RigFile, RigPart, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("parent_span.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-parent-span",
        Level::Error,
        "a sub-rig names more than one bone of the rig of the body",
    )
});

const AS_WRITTEN: Case = &[(
    Mpfb,
    Level::Warning,
    "silently binds the constraint to the `subtarget` as it is written",
)];

/// MPFB takes two places for the same if they are nearer to each other than this, in metres
/// (`docs/loaders/mpfb/custom-rigs.md#references-to-the-parent-rig`).
const NEAR: f64 = 0.01;

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let figure = Figure::of(view);
    let joints = figure.as_ref().map(Figure::joints);
    let of_body = LazyCell::new(|| ends_of_body(view, joints.as_ref()));
    for (file, rig) in view.own_rigs() {
        let bound = rig
            .bones
            .iter()
            .flat_map(|bone| bone.constraints.iter().map(move |one| (bone, one)));
        let targets = bound.flat_map(|(bone, one)| one.targets.iter().map(move |own| (bone, own)));
        if file.part != RigPart::Asset {
            let foreign = targets
                .filter(|(_, (target, _))| matches!(target, Target::Parent | Target::Span(..)));
            out.extend(in_rig_of_body(
                file,
                rig,
                &foreign
                    .map(|(bone, _)| bone.name.as_str())
                    .collect::<Vec<_>>(),
            ));
            continue;
        }
        let Some(joints) = joints.as_ref().filter(|_| has_asset(file)) else {
            continue;
        };
        for (bone, (target, subtarget)) in targets {
            // Without a `subtarget` MPFB does not look for the bone.
            if let (Target::Span(_, head, tail), Some(_)) = (target, subtarget) {
                out.extend(unknown(file, rig, bone, [head, tail], joints, cx));
                out.extend(several(&of_body, file, rig, bone, [head, tail], joints));
            }
        }
    }
}

fn in_rig_of_body(file: &RigFile<'_>, rig: &Rig, bones: &[&str]) -> Option<Finding> {
    let first = bones.first()?;
    let message = format!(
        "a constraint of bone `{first}` names another rig{}",
        such(bones.len(), "constraints")
    );
    let finding = at_bones(&RULE, file, rig, bones, "constraints", message)?.key("body");
    Some(finding.help("write `\"target\": true` for the rig itself"))
}

fn unknown(
    file: &RigFile<'_>,
    rig: &Rig,
    bone: &RigBone,
    ends: [&String; 2],
    joints: &Joints<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let name = ends.into_iter().find(|name| joints.cube(name).is_none())?;
    let message = format!(
        "joint `{name}` in a constraint of bone `{}` does not exist",
        bone.name
    );
    let near = cx.suggestions.nearest(name, joints.names());
    let finding = at_bones(&RULE, file, rig, &[&bone.name], "constraints", message)?.key("joint");
    Some(
        finding
            .case(AS_WRITTEN)
            .help(did_you_mean(near, "name a joint of the base mesh")),
    )
}

/// The ends of the bones of each rig of the body, those farthest on the right first.
fn ends_of_body<'v>(view: &'v View<'_>, joints: Option<&Joints<'_>>) -> Vec<(&'v str, Vec<Ends>)> {
    let of_body = view.rigs.iter().filter(|rig| rig.part == RigPart::Standard);
    let ends = |rig: &'v RigFile<'_>| {
        let bones = placed(rig.definition()?, joints?);
        let mut ends: Vec<Ends> = bones.iter().filter_map(Placed::ends).collect();
        ends.sort_by(|(one, _), (other, _)| one[0].total_cmp(&other[0]));
        Some((rig.name, ends))
    };
    of_body.filter_map(ends).collect()
}

/// A finding if the rig of a body has several bones between the two joints, and no single bone from
/// the one to the other.
fn several(
    of_body: &[(&str, Vec<Ends>)],
    file: &RigFile<'_>,
    rig: &Rig,
    bone: &RigBone,
    [head, tail]: [&String; 2],
    joints: &Joints<'_>,
) -> Option<Finding> {
    let (from, to) = (joints.cube(head)?, joints.cube(tail)?);
    let spanned = of_body.iter().filter(|(_, ends)| is_chain(ends, from, to));
    let wrong: Vec<&str> = spanned.map(|(name, _)| *name).collect();
    let first = wrong.first()?;
    let message = format!(
        "from `{head}` to `{tail}` in a constraint of bone `{}` lies more than one bone of the \
            rig `{first}`{}",
        bone.name,
        such(wrong.len(), "rigs")
    );
    let finding = at_bones(&RULE, file, rig, &[&bone.name], "constraints", message)?.key("span");
    Some(stops(
        file,
        finding.help("name the joints at which one bone begins and ends"),
    ))
}

/// Where a bone begins and ends.
type Ends = (Vec3, Vec3);

/// The longest chain of bones that is followed.
const LONGEST: usize = 64;

/// Whether several bones, each beginning where another ends, lead from one place to another, and no
/// single bone does.
fn is_chain(ends: &[Ends], from: Vec3, to: Vec3) -> bool {
    // The bones that begin at a place, by their numbers.
    let next = |at: Vec3| {
        let start = ends.partition_point(|(head, _)| head[0] < at[0] - NEAR);
        let heads = ends.iter().enumerate().skip(start);
        heads
            .take_while(move |(_, (head, _))| head[0] <= at[0] + NEAR)
            .filter(move |(_, (head, _))| apart(*head, at) < NEAR)
            .map(|(number, (_, tail))| (number, *tail))
    };
    let is_at_end = |bones: &[(usize, Vec3)]| bones.iter().any(|(_, tail)| apart(*tail, to) < NEAR);
    let mut bones: Vec<(usize, Vec3)> = next(from).collect();
    if is_at_end(&bones) {
        return false;
    }
    // Each bone is followed once: short ones lead to themselves.
    let mut followed: BTreeSet<usize> = bones.iter().map(|(number, _)| *number).collect();
    for _ in 0..LONGEST {
        bones = bones
            .iter()
            .flat_map(|(_, tail)| next(*tail))
            .filter(|(number, _)| followed.insert(*number))
            .collect();
        if is_at_end(&bones) {
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_bones_do_not_hide_a_chain() {
        let bone = |from: f64, to: f64| ([from, 0.0, 0.0], [to, 0.0, 0.0]);
        let mut ends = vec![bone(0.0, 1.0), bone(1.0, 2.0)];
        ends.extend((0..100).map(|_| bone(0.0, 0.005)));
        ends.sort_by(|(one, _), (other, _)| one[0].total_cmp(&other[0]));
        assert!(is_chain(&ends, [0.0; 3], [2.0, 0.0, 0.0]));
        assert!(!is_chain(&ends, [0.0; 3], [1.0, 0.0, 0.0]));
        assert!(!is_chain(&ends, [0.0; 3], [3.0, 0.0, 0.0]));
    }
}
