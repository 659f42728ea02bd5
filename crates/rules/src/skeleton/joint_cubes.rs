//! The cubes of a mesh that joints are the centres of, and which of them listed vertices are of.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_eval::target_measure::cubes_of;
use mhlint_formats::obj::{Face, Mesh};

/// The joint cubes that share no vertex with another one.
pub(super) struct JointCubes {
    /// Their groups and their vertices.
    all: Vec<(String, Vec<u32>)>,
    /// The place in `all` of the cube that a vertex is of.
    of_vertices: BTreeMap<u32, usize>,
    /// The joints that they are named after.
    joints: BTreeSet<String>,
}

/// A cube of which some vertices are listed.
pub(super) struct Touched<'c> {
    /// Its group.
    pub(super) group: &'c str,
    /// How many of its vertices are listed.
    pub(super) listed: usize,
    /// How many it has.
    pub(super) all: usize,
}

impl JointCubes {
    pub(super) fn of(mesh: &Mesh) -> Self {
        let all = apart(mesh);
        let of_vertices = all
            .iter()
            .enumerate()
            .flat_map(|(cube, (_, vertices))| vertices.iter().map(move |vertex| (*vertex, cube)))
            .collect();
        let joints = all.iter().filter_map(|(group, _)| joint_of(group));
        let joints = joints.map(str::to_owned).collect();
        Self {
            all,
            of_vertices,
            joints,
        }
    }

    /// Whether one is named after a joint.
    pub(super) fn has(&self, joint: &str) -> bool {
        self.joints.contains(joint)
    }

    /// The cubes that some of these vertices are of.
    pub(super) fn touched(&self, vertices: impl Iterator<Item = i64>) -> Vec<Touched<'_>> {
        let mut listed: BTreeMap<usize, usize> = BTreeMap::new();
        vertices
            .filter_map(|vertex| self.of_vertices.get(&u32::try_from(vertex).ok()?))
            .for_each(|cube| *listed.entry(*cube).or_default() += 1);
        let touched = |(cube, listed): (usize, usize)| {
            let (group, vertices) = self.all.get(cube)?;
            Some(Touched {
                group,
                listed,
                all: vertices.len(),
            })
        };
        listed.into_iter().filter_map(touched).collect()
    }

    /// The joint of the one cube that these are the vertices of, all of them.
    pub(super) fn whole(&self, vertices: impl Iterator<Item = i64>) -> Option<&str> {
        match self.touched(vertices).as_slice() {
            [cube] if cube.listed == cube.all => joint_of(cube.group),
            _ => None,
        }
    }
}

/// The joint that a cube is named after.
fn joint_of(group: &str) -> Option<&str> {
    group.strip_prefix("joint-")
}

/// The cubes of a mesh but for those that share a vertex.
fn apart(mesh: &Mesh) -> Vec<(String, Vec<u32>)> {
    let face = |face: &Face| {
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
