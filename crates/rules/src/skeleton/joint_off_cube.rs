//! A joint is the centre of its cube.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx};
use super::joint_cubes::{JointCubes, Touched};
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhskel::Joint;
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "places such joints off their cubes, and moves them with the wrong vertices",
        ),
        (
            Makehuman1,
            "places such joints off their cubes, and moves them with the wrong vertices",
        ),
    ],
    docs: include_str!("joint_off_cube.md").trim_ascii_end(),
    counts: "joints",
    ..RuleInfo::new(
        "skeleton-joint-off-cube",
        Level::Warning,
        "a joint lists part of its cube and other vertices",
    )
});

/// A joint, and the cube that it means.
type OffCube<'a> = (&'a Joint, Touched<'a>);

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = body.whole_mesh() else {
        return;
    };
    let count = i64::try_from(mesh.positions.len()).unwrap_or(i64::MAX);
    let cubes = JointCubes::of(mesh);
    for rig in rigs(body) {
        let joints = &rig.skeleton.joints;
        out.extend(exchanged(rig.file, joints, &cubes));
        let off = |joint| off_cube(joint, &cubes, count);
        let off: Vec<OffCube<'_>> = joints.iter().filter_map(off).collect();
        let Some((joint, cube)) = off.first() else {
            continue;
        };
        let first = format!(
            "`{}` lists {} of the {} vertices of `{}`, and others",
            joint.name, cube.listed, cube.all, cube.group
        );
        let message = match off.len() {
            1 => format!("joint {first}"),
            count => format!("{count} joints list part of their cube and other vertices: {first}"),
        };
        let help = if off.iter().all(|(joint, _)| is_one_based(joint, &cubes)) {
            "subtract 1 from each of these numbers: vertices are counted from 0"
        } else {
            "list the vertices of the cube, counted from 0"
        };
        out.push(
            RULE.at(rig.file, Place::pointer(["joints", &joint.name]), message)
                .confidence(Confidence::Medium)
                .help(help)
                .evidence(
                    Evidence::of_cases(off.iter().map(|(joint, _)| &joint.name))
                        .out_of(joints.len()),
                ),
        );
    }
}

/// Joints that list the whole cube of one another, where each has a cube of its own name. Where
/// most do, it is the order of the mesh (`mesh-vertex-order`).
fn exchanged(file: &FileFacts, joints: &[Joint], cubes: &JointCubes) -> Option<Finding> {
    let whole = |joint: &Joint| cubes.whole(joint.vertices.iter().flatten().copied());
    let lists: BTreeMap<&str, &str> = joints
        .iter()
        .filter_map(|one| Some((one.name.as_str(), whole(one)?)))
        .collect();
    let strays = |joint: &str| lists.get(joint).is_some_and(|other| *other != joint);
    let exchanged = lists
        .iter()
        .filter(|(joint, other)| strays(joint) && strays(other) && cubes.has(joint));
    let exchanged: Vec<(&str, &str)> = exchanged.map(|(joint, other)| (*joint, *other)).collect();
    let (joint, other) = exchanged.first()?;
    let first = format!("`{joint}` lists the vertices of group `joint-{other}`");
    let message = match exchanged.len() {
        1 => format!("joint {first}"),
        count => format!("{count} joints list the cube of another joint: {first}"),
    };
    let finding = RULE
        .at(file, Place::pointer(["joints", joint]), message)
        .key("exchanged");
    let help = "list the vertices of the group named after the joint, or restore the vertex order \
        of base.obj";
    let evidence =
        Evidence::of_cases(exchanged.iter().map(|(joint, _)| joint)).out_of(joints.len());
    Some(
        finding
            .confidence(Confidence::Medium)
            .help(help)
            .evidence(evidence),
    )
}

fn off_cube<'a>(joint: &'a Joint, cubes: &'a JointCubes, count: i64) -> Option<OffCube<'a>> {
    // A vertex that the mesh lacks has a finding of its own.
    let listed = joint
        .vertices
        .as_deref()
        .filter(|listed| listed.iter().all(|vertex| (0..count).contains(vertex)))?;
    let touched = cubes.touched(listed.iter().copied());
    let is_whole = touched.iter().any(|cube| cube.listed >= cube.all);
    let most = touched.into_iter().max_by_key(|cube| cube.listed)?;
    let is_off = !is_whole && 2 * most.listed >= most.all && most.listed < listed.len();
    is_off.then_some((joint, most))
}

/// Whether the vertices before those of the joint are a whole cube.
fn is_one_based(joint: &Joint, cubes: &JointCubes) -> bool {
    let listed = joint.vertices.iter().flatten();
    let before = listed.map(|vertex| vertex.saturating_sub(1));
    cubes.whole(before).is_some()
}
