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
    /// The vertices that a face uses, in order.
    in_faces: Vec<u32>,
    /// How many of these are in groups that are shown.
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
    /// How many there are.
    pub count: usize,
    /// How many of them are in a group that is shown.
    pub shown: usize,
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
        let used = (0..).zip(&homes);
        let in_faces = used.filter_map(|(vertex, home)| home.map(|_| vertex));
        let mut landmarks = Self {
            mesh,
            in_faces: in_faces.collect(),
            homes,
            shown: 0,
            is_shown: shown,
            bones,
        };
        landmarks.shown = landmarks.tally(&landmarks.in_faces).1;
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

    /// How many of these vertices a face uses, and how many of them are in groups that are shown.
    fn tally(&self, vertices: &[u32]) -> (usize, usize) {
        let homes = vertices.iter().filter_map(|vertex| self.home(*vertex));
        homes.fold((0, 0), |(used, shown), home| {
            let is_shown = self.is_shown.get(home) == Some(&true);
            (used + 1, shown + usize::from(is_shown))
        })
    }

    /// Vertices that a face uses, without those in `reached`, which are in order.
    pub(super) fn unreached<'b>(&'b self, reached: &'b [u32]) -> Unreached<'b> {
        let (used, shown) = self.tally(reached);
        Unreached {
            landmarks: self,
            reached,
            count: self.in_faces.len().saturating_sub(used),
            shown: self.shown.saturating_sub(shown),
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

impl Unreached<'_> {
    /// The vertices, in order.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        let mut reached = self.reached.iter().copied().peekable();
        let used = self.landmarks.in_faces.iter().copied();
        used.filter(move |vertex| {
            while reached.next_if(|other| other < vertex).is_some() {}
            reached.peek() != Some(vertex)
        })
    }
}

/// The bones whose ends can be told: a joint is the mean of its vertices. None of a skeleton with
/// more than `MOST_BONES`: findings times bones have no end.
fn bones<'m>(mesh: &Mesh, skeleton: &'m Skeleton) -> Vec<(&'m str, [Point; 2])> {
    if skeleton.bones.len() > MOST_BONES {
        return Vec::new();
    }
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

/// Bones among which the one nearest to a vertex is looked for. The largest skeletons have
/// hundreds.
const MOST_BONES: usize = 4096;

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
    fn vertices_that_are_not_reached_are_counted_by_whether_they_are_shown() {
        let mesh = obj::parse(
            b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nv 0 1 0\nv 0 0 1\ng b\nf 1 2 3\ng a\nf 3 5 6\n",
        );
        let is_shown = |group: &str| group == "a";
        let landmarks = Landmarks::of(&mesh, None, is_shown);
        let told = |reached: &[u32]| {
            let unreached = landmarks.unreached(reached);
            assert_eq!(unreached.count, unreached.vertices().count());
            (unreached.vertices().collect(), unreached.shown)
        };
        assert_eq!(told(&[]), (vec![0, 1, 2, 4, 5], 2));
        assert_eq!(told(&[1, 3, 4, 5, 77]), (vec![0, 2], 0));
        assert_eq!(told(&[0, 1, 2, 4, 5]), (Vec::<u32>::new(), 0));
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
