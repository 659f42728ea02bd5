//! The cubes that a base mesh has for joints: they show whether its vertices have the numbers that
//! skeletons and tables know.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_formats::mhskel::Joint;
use mhlint_formats::obj::{Group, Mesh};

/// What begins the names of the groups that are cubes of joints.
const CUBE: &str = "joint-";
/// Vertices of a cube.
const CORNERS: usize = 8;
/// Fewer joints show nothing.
const FEWEST_JOINTS: usize = 4;

/// Joints that are not where their cubes are, or cubes that are none any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strays {
    /// Whether it is the cubes that are torn apart: vertices were put between the others, and the
    /// faces kept their numbers.
    pub are_torn: bool,
    /// So many.
    pub strayed: usize,
    /// Of so many.
    pub of: usize,
}

/// Whether most joints of a skeleton stray, or most cubes are torn. A few may be meant so, or are
/// slips of the skeleton.
pub fn strays_of(mesh: &Mesh, joints: &[Joint]) -> Option<Strays> {
    strays(
        mesh,
        joints
            .iter()
            .filter_map(|joint| Some((joint.name.as_str(), joint.vertices.clone()?))),
    )
}

/// The same for joints by their names and vertices.
pub fn strays<'j>(
    mesh: &Mesh,
    joints: impl Iterator<Item = (&'j str, Vec<i64>)>,
) -> Option<Strays> {
    let cubes = Cubes::of(mesh);
    let used = used(mesh);
    // Where the cube was deleted its vertices are left, and they have their numbers.
    let is_left_over = |vertex: &i64| {
        usize::try_from(*vertex).is_ok_and(|vertex| used.get(vertex) == Some(&false))
    };
    let joints =
        joints.filter(|(_, vertices)| vertices.is_empty() || !vertices.iter().all(is_left_over));
    let strayed = || {
        joints
            .filter_map(|(name, vertices)| cubes.has_stray(name, &vertices))
            .collect::<Vec<_>>()
    };
    most(&cubes.torn(mesh), true).or_else(|| most(&strayed(), false))
}

/// Of each vertex whether a face has it.
fn used(mesh: &Mesh) -> Vec<bool> {
    let mut used = vec![false; mesh.positions.len()];
    for vertex in mesh.vertices_of_faces().flatten() {
        if let Some(one) = usize::try_from(*vertex)
            .ok()
            .and_then(|vertex| used.get_mut(vertex))
        {
            *one = true;
        }
    }
    used
}

/// So many that are true of all, where these are most.
fn most(all: &[bool], are_torn: bool) -> Option<Strays> {
    let (strayed, of) = (all.iter().filter(|one| **one).count(), all.len());
    (of >= FEWEST_JOINTS && 2 * strayed > of).then_some(Strays {
        are_torn,
        strayed,
        of,
    })
}

/// Whether each corner has one across the centre, give or take a quarter of the size.
fn is_symmetric(corners: &[[f32; 3]]) -> bool {
    let along = |axis: usize| {
        corners
            .iter()
            .filter_map(move |corner| corner.get(axis).copied())
    };
    let range = |axis: usize| {
        along(axis).fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), at| {
            (low.min(at), high.max(at))
        })
    };
    let size = [0, 1, 2]
        .map(range)
        .iter()
        .fold(0.0, |most: f32, (low, high)| most.max(high - low));
    let twice = [0, 1, 2].map(|axis| along(axis).sum::<f32>() * 2.0 / CORNERS as f32);
    let is_across = |one: &[f32; 3], other: &[f32; 3]| {
        one.iter()
            .zip(other)
            .zip(&twice)
            .all(|((one, other), twice)| (one + other - twice).abs() <= size / 4.0)
    };
    corners
        .iter()
        .all(|one| corners.iter().any(|other| is_across(one, other)))
}

/// The cubes of joints: first and last vertex by name, and all in order, each with the highest last
/// vertex so far.
struct Cubes<'m> {
    by_name: BTreeMap<&'m str, (u32, u32)>,
    in_order: Vec<(u32, u32)>,
    /// First vertices of those with eight in a row.
    whole: BTreeSet<i64>,
}

impl<'m> Cubes<'m> {
    fn of(mesh: &'m Mesh) -> Self {
        // Where faces of one group are put into another one, the vertices of neither say anything.
        let mixed = mesh.facts.mixed_groups();
        let mut by_name = BTreeMap::new();
        for (name, ends) in mesh
            .groups
            .iter()
            .filter(|group| !mixed.contains(group.name.as_str()))
            .filter_map(cube)
        {
            by_name.entry(name).or_insert(ends);
        }
        let is_whole = |(first, last): &(u32, u32)| {
            last.checked_sub(*first)
                .is_some_and(|more| more as usize + 1 == CORNERS)
        };
        let whole = by_name
            .values()
            .filter(|ends| is_whole(ends))
            .map(|(first, _)| i64::from(*first))
            .collect();
        let mut in_order: Vec<(u32, u32)> = by_name.values().copied().collect();
        in_order.sort_unstable();
        let mut highest = 0;
        for (_, last) in &mut in_order {
            highest = highest.max(*last);
            *last = highest;
        }
        Self {
            by_name,
            in_order,
            whole,
        }
    }

    /// Of each cube whether it is torn apart: that a corner has none across from it.
    fn torn(&self, mesh: &Mesh) -> Vec<bool> {
        let corners = self.whole.iter().filter_map(|first| {
            let first = usize::try_from(*first).ok()?;
            mesh.positions.get(first..first + CORNERS)
        });
        corners.map(|corners| !is_symmetric(corners)).collect()
    }

    /// Whether a joint lies in no cube: in that of its name, or where there is none in any. Nothing
    /// where it seems not to be meant for one.
    fn has_stray(&self, name: &str, vertices: &[i64]) -> Option<bool> {
        let is_in = |first: u32, last: u32| {
            vertices
                .iter()
                .any(|vertex| (i64::from(first)..=i64::from(last)).contains(vertex))
        };
        // The corners of a cube, of which all have moved by the same number.
        let first = vertices.first().copied().filter(|_| is_run(vertices));
        let has_moved =
            |from: i64| self.whole.contains(&from) && first.is_some_and(|first| first != from);
        match self.by_name.get(name) {
            Some((from, to)) => {
                (!vertices.is_empty()).then(|| !is_in(*from, *to) || has_moved(i64::from(*from)))
            }
            None if self.whole.len() >= FEWEST_JOINTS => {
                first.map(|first| !self.whole.contains(&first))
            }
            None => (first.is_some() && !self.by_name.is_empty()).then(|| !self.meet(vertices)),
        }
    }

    /// Whether vertices in a row meet a cube.
    fn meet(&self, run: &[i64]) -> bool {
        let (Some(from), Some(to)) = (run.first(), run.last()) else {
            return false;
        };
        let begun = self
            .in_order
            .partition_point(|(first, _)| i64::from(*first) <= *to);
        begun
            .checked_sub(1)
            .and_then(|at| self.in_order.get(at))
            .is_some_and(|(_, last)| i64::from(*last) >= *from)
    }
}

fn cube(group: &Group) -> Option<(&str, (u32, u32))> {
    Some((group.name.strip_prefix(CUBE)?, group.vertices?))
}

/// Whether these are the vertices of a cube as programs number them; eight around a limb are not in
/// a row.
fn is_run(vertices: &[i64]) -> bool {
    vertices.len() == CORNERS
        && vertices
            .windows(2)
            .all(|pair| matches!(pair, [one, next] if one.checked_add(1) == Some(*next)))
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use super::*;
    use mhlint_formats::obj;

    /// Six cubes in a row, with so many vertices in front that no face knows of.
    fn mesh(in_front: usize) -> Mesh {
        let mut text = "v 9 9 9\n".repeat(in_front);
        for cube in 0..6 {
            for corner in 0..CORNERS {
                let [x, y, z] =
                    [corner & 1, corner >> 1 & 1, corner >> 2].map(|side| side as f32 / 10.0);
                writeln!(text, "v {} {y} {z}", x + cube as f32).unwrap();
            }
        }
        for cube in 0..6 {
            writeln!(text, "g joint-{cube}").unwrap();
            for face in [
                [0, 1, 3, 2],
                [4, 5, 7, 6],
                [0, 1, 5, 4],
                [2, 3, 7, 6],
                [0, 2, 6, 4],
                [1, 3, 7, 5],
            ] {
                let face = face.map(|corner| (cube * CORNERS + corner + 1).to_string());
                writeln!(text, "f {}", face.join(" ")).unwrap();
            }
        }
        obj::parse(text.as_bytes())
    }

    fn of_joints(mesh: &Mesh, by: i64) -> Option<(bool, usize, usize)> {
        let joints = (0..6).map(|cube: i64| ("hand", (cube * 8 + by..cube * 8 + by + 8).collect()));
        strays(mesh, joints).map(|strays| (strays.are_torn, strays.strayed, strays.of))
    }

    #[test]
    fn joints_stray_where_all_numbers_moved() {
        assert_eq!(of_joints(&mesh(0), 0), None);
        assert_eq!(of_joints(&mesh(0), 1), Some((false, 6, 6)));
    }

    #[test]
    fn a_cube_that_was_deleted_has_left_its_vertices() {
        let mut mesh = mesh(0);
        mesh.groups.truncate(2);
        mesh.faces.truncate(12);
        assert_eq!(of_joints(&mesh, 0), None);
    }

    #[test]
    fn cubes_are_torn_where_places_moved_and_faces_did_not() {
        assert_eq!(of_joints(&mesh(1), 0), Some((true, 6, 6)));
    }
}
