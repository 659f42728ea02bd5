//! Where on a body a vertex lies, in words: its group, and the bone nearest to it.

use std::collections::BTreeMap;
use std::fmt::Display;

use mhlint_formats::mhskel::Skeleton;
use mhlint_formats::obj::Mesh;

type Point = [f32; 3];

/// What the vertices of a mesh are told by.
#[derive(Debug)]
pub struct Landmarks<'m> {
    mesh: &'m Mesh,
    /// Number of the group of each vertex.
    homes: Vec<Option<u32>>,
    /// How many vertices that a face uses are in each group.
    used: BTreeMap<&'m str, usize>,
    /// How many they are together, and how many of them in groups that are shown.
    all: usize,
    shown: usize,
    /// Whether the group of a number is shown.
    is_shown: Vec<bool>,
    /// Bones from head to tail.
    bones: Vec<(&'m str, [Point; 2])>,
}

/// The part of a body that a vertex belongs to, the one that everybody sees first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Region {
    /// A group that is shown.
    Visible,
    /// Any other group: helpers and joint cubes.
    Helper,
    /// None: no face uses it.
    Faceless,
}

/// Vertices that a face uses and a file does not reach. Costs what is reached: files times vertices
/// have no end.
#[derive(Debug)]
pub struct Unreached<'b> {
    landmarks: &'b Landmarks<'b>,
    /// In order.
    reached: &'b [u32],
    /// How many are reached in each group.
    taken: BTreeMap<&'b str, usize>,
    /// How many there are.
    pub count: usize,
    /// Whether some of them are in a group that is shown.
    pub is_shown: bool,
}

impl<'m> Landmarks<'m> {
    /// Walks the mesh once.
    pub(super) fn of(
        mesh: &'m Mesh,
        skeleton: Option<&'m Skeleton>,
        is_shown: impl Fn(&str) -> bool,
    ) -> Self {
        let homes = mesh.homes();
        let bones = skeleton.map_or_else(Vec::new, |skeleton| bones(mesh, skeleton));
        let shown = mesh
            .groups
            .iter()
            .map(|group| is_shown(&group.name))
            .collect();
        let mut landmarks = Self {
            mesh,
            homes,
            used: BTreeMap::new(),
            all: 0,
            shown: 0,
            is_shown: shown,
            bones,
        };
        landmarks.used =
            landmarks.tally(0..u32::try_from(landmarks.homes.len()).unwrap_or(u32::MAX));
        landmarks.all = landmarks.used.values().sum();
        landmarks.shown = count(&landmarks.used, is_shown);
        landmarks
    }

    /// Name of the group of a vertex; `None` if no face uses it.
    pub(super) fn group(&self, vertex: u32) -> Option<&'m str> {
        self.mesh
            .groups
            .get(self.home(vertex)?)
            .map(|group| group.name.as_str())
    }

    fn home(&self, vertex: u32) -> Option<usize> {
        self.homes
            .get(vertex as usize)
            .copied()
            .flatten()
            .map(|home| home as usize)
    }

    /// What a vertex is part of.
    pub(super) fn region(&self, vertex: u32) -> Region {
        match self.home(vertex).and_then(|home| self.is_shown.get(home)) {
            Some(true) => Region::Visible,
            Some(false) => Region::Helper,
            None => Region::Faceless,
        }
    }

    fn tally(&self, vertices: impl IntoIterator<Item = u32>) -> BTreeMap<&'m str, usize> {
        let mut tally = BTreeMap::new();
        for group in vertices.into_iter().filter_map(|vertex| self.group(vertex)) {
            *tally.entry(group).or_default() += 1;
        }
        tally
    }

    /// Vertices that a face uses, without those in `reached`, which are in order.
    pub(super) fn unreached<'b>(
        &'b self,
        reached: &'b [u32],
        is_shown: impl Fn(&str) -> bool,
    ) -> Unreached<'b> {
        let taken = self.tally(reached.iter().copied());
        let missing = self.all.saturating_sub(taken.values().sum());
        let is_shown = count(&taken, is_shown) < self.shown;
        Unreached {
            landmarks: self,
            reached,
            taken,
            count: missing,
            is_shown,
        }
    }

    /// Name of the bone nearest to a vertex.
    fn bone(&self, vertex: u32) -> Option<&'m str> {
        let at = *self
            .mesh
            .positions
            .get(vertex as usize)
            .filter(|at| at.iter().all(|part| part.is_finite()))?;
        let distance = |[head, tail]: &[Point; 2]| from_segment(at, *head, *tail);
        let nearest = self
            .bones
            .iter()
            .min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)));
        nearest.map(|(name, _)| *name)
    }

    /// ``vertex 17960 (`helper-tights`, near `pelvis.L`)``, as far as it is known.
    pub fn vertex(&self, vertex: impl TryInto<u32> + Display + Copy) -> String {
        let place = vertex.try_into().ok().and_then(|vertex| self.place(vertex));
        place.map_or_else(
            || format!("vertex {vertex}"),
            |place| format!("vertex {vertex} ({place})"),
        )
    }

    /// `` `helper-tights`, near `pelvis.L` ``, as far as it is known.
    pub fn place(&self, vertex: u32) -> Option<String> {
        let bone = self.bone(vertex).map(|bone| format!("near `{bone}`"));
        let parts: Vec<String> = self
            .group(vertex)
            .map(|group| format!("`{group}`"))
            .into_iter()
            .chain(bone)
            .collect();
        (!parts.is_empty()).then(|| parts.join(", "))
    }
}

impl<'b> Unreached<'b> {
    /// The vertices, in order.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        let mut reached = self.reached.iter().copied().peekable();
        let used = (0..)
            .zip(&self.landmarks.homes)
            .filter_map(|(vertex, home)| home.map(|_| vertex));
        used.filter(move |vertex| {
            while reached.next_if(|other| other < vertex).is_some() {}
            reached.peek() != Some(vertex)
        })
    }

    /// How many are in each group, by name.
    pub fn groups(&self) -> impl Iterator<Item = (&'b str, usize)> {
        let left = |(group, used): (&&'b str, &usize)| {
            (
                *group,
                used.saturating_sub(self.taken.get(group).copied().unwrap_or(0)),
            )
        };
        self.landmarks
            .used
            .iter()
            .map(left)
            .filter(|(_, count)| *count > 0)
    }
}

/// How many vertices are in the groups that are wanted.
fn count(groups: &BTreeMap<&str, usize>, is_wanted: impl Fn(&str) -> bool) -> usize {
    groups
        .iter()
        .filter(|(group, _)| is_wanted(group))
        .map(|(_, count)| count)
        .sum()
}

/// The bones whose ends can be told: a joint is the mean of its vertices.
fn bones<'m>(mesh: &Mesh, skeleton: &'m Skeleton) -> Vec<(&'m str, [Point; 2])> {
    let joints = skeleton.joints.iter().filter_map(|joint| {
        let vertices = joint
            .vertices
            .as_deref()
            .filter(|vertices| !vertices.is_empty())?;
        let at = |vertex: &i64| {
            usize::try_from(*vertex)
                .ok()
                .and_then(|vertex| mesh.positions.get(vertex))
                .copied()
        };
        Some((
            joint.name.as_str(),
            mean(&vertices.iter().map(at).collect::<Option<Vec<Point>>>()?),
        ))
    });
    let joints: BTreeMap<&str, Point> = joints.collect();
    let end = |joint: &Option<String>| joints.get(joint.as_deref()?).copied();
    let ends = skeleton
        .bones
        .iter()
        .filter_map(|bone| Some((bone, [end(&bone.head)?, end(&bone.tail)?])));
    ends.map(|(bone, ends)| (bone.name.as_str(), ends))
        .collect()
}

fn mean(points: &[Point]) -> Point {
    let sum = points.iter().fold([0.0; 3], |sum: Point, point| {
        [0, 1, 2].map(|axis| sum[axis] + point[axis])
    });
    sum.map(|sum| sum / points.len() as f32)
}

/// The square of the distance of a point from a segment.
fn from_segment(point: Point, head: Point, tail: Point) -> f32 {
    let minus = |a: Point, b: Point| [0, 1, 2].map(|axis| a[axis] - b[axis]);
    let dot = |a: Point, b: Point| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
    let (along, to) = (minus(tail, head), minus(point, head));
    let length = dot(along, along);
    let share = if length > 0.0 {
        (dot(to, along) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let off = minus(to, along.map(|part| part * share));
    dot(off, off)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::{mhskel, obj};
    use mhlint_json as json;

    #[test]
    fn a_vertex_is_told_by_its_group_and_the_nearest_bone() {
        let mesh =
            obj::parse(b"v 0 0 0\nv 0 4 0\nv 5 4 0\nv 1 1 0\nv 4 5 0\nv 9 9 9\ng arm\nf 1 4 2\ng hand\nf 2 5 3\n");
        let text = br#"{"joints": {"a": [0], "b": [1], "c": [2], "d": [77]}, "bones": {
            "upper": {"head": "a", "tail": "b", "parent": null},
            "lower": {"head": "b", "tail": "c", "parent": "upper"},
            "lost": {"head": "c", "tail": "d", "parent": "lower"}}}"#;
        let skeleton = mhskel::read(&json::parse(text).unwrap());
        let landmarks = Landmarks::of(&mesh, Some(&skeleton), |_| true);
        let told = [3, 4, 5, 99].map(|vertex| landmarks.place(vertex));
        let expected = [
            Some("`arm`, near `upper`"),
            Some("`hand`, near `lower`"),
            Some("near `lower`"),
            None,
        ];
        assert_eq!(told, expected.map(|text| text.map(str::to_owned)));
        assert_eq!(Landmarks::of(&mesh, None, |_| true).place(5), None);
    }

    #[test]
    fn vertices_that_are_not_reached_are_counted_in_their_groups() {
        let mesh = obj::parse(
            b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nv 0 1 0\nv 0 0 1\ng b\nf 1 2 3\ng a\nf 3 5 6\n",
        );
        let is_shown = |group: &str| group == "a";
        let landmarks = Landmarks::of(&mesh, None, is_shown);
        let told = |reached: &[u32]| {
            let unreached = landmarks.unreached(reached, is_shown);
            let groups: Vec<(String, usize)> = unreached
                .groups()
                .map(|(group, count)| (group.to_owned(), count))
                .collect();
            assert_eq!(unreached.count, unreached.vertices().count());
            (
                unreached.vertices().collect::<Vec<u32>>(),
                groups,
                unreached.is_shown,
            )
        };
        let group = |name: &str, count| (name.to_owned(), count);
        assert_eq!(
            told(&[]),
            (
                vec![0, 1, 2, 4, 5],
                vec![group("a", 2), group("b", 3)],
                true
            )
        );
        assert_eq!(
            told(&[1, 3, 4, 5, 77]),
            (vec![0, 2], vec![group("b", 2)], false)
        );
        assert_eq!(told(&[0, 1, 2, 4, 5]), (vec![], vec![], false));
        let regions = [4, 0, 3, 99].map(|vertex| landmarks.region(vertex));
        assert_eq!(
            regions,
            [
                Region::Visible,
                Region::Helper,
                Region::Faceless,
                Region::Faceless
            ]
        );
    }
}
