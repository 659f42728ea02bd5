//! A joint is the centre of its cube.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::rigs;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::target_measure::cubes_of;
use mhlint_formats::mhskel::Joint;
use mhlint_formats::obj::Mesh;
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

/// A joint, the name of the cube that it means, how many of its vertices it lists, and how many
/// that cube has.
type OffCube<'a> = (&'a Joint, &'a str, usize, usize);

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = body.whole_mesh() else {
        return;
    };
    let count = i64::try_from(mesh.positions.len()).unwrap_or(i64::MAX);
    let cubes = cubes(mesh);
    let cube_of: BTreeMap<u32, usize> = cubes
        .iter()
        .enumerate()
        .flat_map(|(cube, (_, all))| all.iter().map(move |vertex| (*vertex, cube)))
        .collect();
    let of_joints: BTreeSet<&str> = cubes.iter().filter_map(of_joint).collect();
    for rig in rigs(body) {
        let joints = &rig.skeleton.joints;
        out.extend(exchanged(rig.file, joints, (&cubes, &of_joints), &cube_of));
        let off = |joint| off_cube(joint, &cubes, &cube_of, count);
        let off: Vec<OffCube<'_>> = joints.iter().filter_map(off).collect();
        let Some((joint, cube, listed, all)) = off.first() else {
            continue;
        };
        let first = format!(
            "`{}` lists {listed} of the {all} vertices of `{cube}`, and others",
            joint.name
        );
        let message = match off.len() {
            1 => format!("joint {first}"),
            count => format!("{count} joints list part of their cube and other vertices: {first}"),
        };
        let is_one_based = off
            .iter()
            .all(|(joint, ..)| is_one_based(joint, &cubes, &cube_of));
        let help = if is_one_based {
            "subtract 1 from each of these numbers: vertices are counted from 0"
        } else {
            "list the vertices of the cube, counted from 0"
        };
        out.push(
            RULE.at(rig.file, Place::pointer(["joints", &joint.name]), message)
                .confidence(Confidence::Medium)
                .help(help)
                .evidence(
                    Evidence::of_cases(off.iter().map(|(joint, ..)| &joint.name))
                        .out_of(rig.skeleton.joints.len()),
                ),
        );
    }
}

/// The joint that a cube is named after.
fn of_joint((name, _): &(String, Vec<u32>)) -> Option<&str> {
    name.strip_prefix("joint-")
}

/// Joints that list the whole cube of one another, where each has a cube of its own name. Where
/// most do, it is the order of the mesh (`mesh-vertex-order`).
fn exchanged(
    file: &FileFacts,
    joints: &[Joint],
    (cubes, of_joints): (&[(String, Vec<u32>)], &BTreeSet<&str>),
    cube_of: &BTreeMap<u32, usize>,
) -> Option<Finding> {
    let named = |cube: usize| cubes.get(cube).and_then(of_joint);
    let whole = |joint: &Joint| {
        let touched = touched(joint.vertices.as_deref()?.iter().copied(), cube_of);
        let (cube, count) = touched.first_key_value().filter(|_| touched.len() == 1)?;
        cubes
            .get(*cube)
            .is_some_and(|(_, all)| all.len() == *count)
            .then(|| named(*cube))
            .flatten()
    };
    let lists: BTreeMap<&str, &str> = joints
        .iter()
        .filter_map(|one| Some((one.name.as_str(), whole(one)?)))
        .collect();
    let has_cube = |joint: &str| of_joints.contains(joint);
    let strays = |joint: &str| lists.get(joint).is_some_and(|other| *other != joint);
    let exchanged = lists
        .iter()
        .filter(|(joint, other)| strays(joint) && strays(other) && has_cube(joint));
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

/// The joint cubes that share no vertex with another one.
fn cubes(mesh: &Mesh) -> Vec<(String, Vec<u32>)> {
    let face = |face: &mhlint_formats::obj::Face| {
        Some((
            mesh.groups.get(face.group as usize)?.name.as_str(),
            face.of(&mesh.corners),
        ))
    };
    let all = cubes_of(mesh.faces.iter().filter_map(face));
    let mut used: BTreeMap<u32, usize> = BTreeMap::new();
    all.iter()
        .flat_map(|(_, cube)| cube)
        .for_each(|vertex| *used.entry(*vertex).or_default() += 1);
    // A face that strayed into another group (`mesh-reopened-group`) makes cubes of two.
    let is_alone = |vertex: &u32| used.get(vertex).is_none_or(|cubes| *cubes == 1);
    all.into_iter()
        .filter(|(_, cube)| cube.iter().all(is_alone))
        .collect()
}

/// How many vertices of each cube are among these.
fn touched(
    vertices: impl Iterator<Item = i64>,
    cube_of: &BTreeMap<u32, usize>,
) -> BTreeMap<usize, usize> {
    let mut touched = BTreeMap::new();
    let cubes = vertices.filter_map(|vertex| cube_of.get(&u32::try_from(vertex).ok()?));
    cubes.for_each(|cube| *touched.entry(*cube).or_default() += 1);
    touched
}

fn off_cube<'a>(
    joint: &'a Joint,
    cubes: &'a [(String, Vec<u32>)],
    cube_of: &BTreeMap<u32, usize>,
    count: i64,
) -> Option<OffCube<'a>> {
    // A vertex that the mesh lacks has a finding of its own.
    let listed = joint
        .vertices
        .as_deref()
        .filter(|listed| listed.iter().all(|vertex| (0..count).contains(vertex)))?;
    let touched = touched(listed.iter().copied(), cube_of);
    let size = |cube: usize| cubes.get(cube).map_or(0, |(_, all)| all.len());
    let (cube, count) = touched.iter().max_by_key(|(_, count)| **count)?;
    let is_whole = touched.iter().any(|(cube, count)| *count >= size(*cube));
    let is_off = !is_whole && 2 * count >= size(*cube) && *count < listed.len();
    let (name, all) = cubes.get(*cube)?;
    is_off.then_some((joint, name.as_str(), *count, all.len()))
}

/// Whether the vertices before those of the joint are a whole cube.
fn is_one_based(
    joint: &Joint,
    cubes: &[(String, Vec<u32>)],
    cube_of: &BTreeMap<u32, usize>,
) -> bool {
    let before = joint
        .vertices
        .iter()
        .flatten()
        .map(|vertex| vertex.saturating_sub(1));
    let touched = touched(before, cube_of);
    touched.len() == 1
        && touched
            .iter()
            .all(|(cube, count)| cubes.get(*cube).is_some_and(|(_, all)| all.len() == *count))
}
