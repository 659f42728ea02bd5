//! Where on a body a vertex lies, in words: its group, and the bone nearest to it.

use std::collections::BTreeMap;

use crate::formats::mhskel::Skeleton;
use crate::formats::obj::Mesh;

type Point = [f32; 3];

/// What the vertices of a mesh are told by.
#[derive(Debug)]
pub(super) struct Landmarks {
    /// Number of the group of each vertex.
    homes: Vec<Option<u32>>,
    /// Bones from head to tail.
    bones: Vec<(String, [Point; 2])>,
}

impl Landmarks {
    /// For one mesh, which is asked with; walks it once.
    pub(super) fn of(mesh: &Mesh, skeleton: Option<&Skeleton>) -> Self {
        Self { homes: mesh.homes(), bones: skeleton.map_or_else(Vec::new, |skeleton| bones(mesh, skeleton)) }
    }

    /// Name of the group of a vertex; `None` if no face uses it.
    pub(super) fn group<'m>(&self, mesh: &'m Mesh, vertex: u32) -> Option<&'m str> {
        let home = self.homes.get(vertex as usize).copied().flatten()?;
        mesh.groups.get(home as usize).map(|group| group.name.as_str())
    }

    /// Leaves out vertices without a face, which nobody sees; how many of the others are in which group.
    pub(super) fn keep_used<'m>(&self, mesh: &'m Mesh, vertices: &mut Vec<u32>) -> BTreeMap<&'m str, usize> {
        let mut counts = vec![0_usize; mesh.groups.len()];
        vertices.retain(|vertex| {
            let home = self.homes.get(*vertex as usize).copied().flatten();
            let count = home.and_then(|home| counts.get_mut(home as usize));
            count.map(|count| *count += 1).is_some()
        });
        let mut groups: BTreeMap<&str, usize> = BTreeMap::new();
        for (group, count) in mesh.groups.iter().zip(counts).filter(|(_, count)| *count > 0) {
            *groups.entry(&group.name).or_default() += count;
        }
        groups
    }

    /// Name of the bone nearest to a vertex.
    fn bone(&self, mesh: &Mesh, vertex: u32) -> Option<&str> {
        let at = *mesh.positions.get(vertex as usize)?;
        let distance = |[head, tail]: &[Point; 2]| from_segment(at, *head, *tail);
        let nearest = self.bones.iter().min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)));
        nearest.map(|(name, _)| name.as_str())
    }

    /// `` `helper-tights`, near `pelvis.L` ``, as far as it is known.
    pub(super) fn place(&self, mesh: &Mesh, vertex: u32) -> Option<String> {
        let bone = self.bone(mesh, vertex).map(|bone| format!("near `{bone}`"));
        let parts: Vec<String> =
            self.group(mesh, vertex).map(|group| format!("`{group}`")).into_iter().chain(bone).collect();
        (!parts.is_empty()).then(|| parts.join(", "))
    }
}

/// The bones whose ends can be told: a joint is the mean of its vertices.
fn bones(mesh: &Mesh, skeleton: &Skeleton) -> Vec<(String, [Point; 2])> {
    let joints = skeleton.joints.iter().filter_map(|joint| {
        let vertices = joint.vertices.as_deref().filter(|vertices| !vertices.is_empty())?;
        let at = |vertex: &i64| usize::try_from(*vertex).ok().and_then(|vertex| mesh.positions.get(vertex)).copied();
        Some((joint.name.as_str(), mean(&vertices.iter().map(at).collect::<Option<Vec<Point>>>()?)))
    });
    let joints: BTreeMap<&str, Point> = joints.collect();
    let end = |joint: &Option<String>| joints.get(joint.as_deref()?).copied();
    let ends = skeleton.bones.iter().filter_map(|bone| Some((bone, [end(&bone.head)?, end(&bone.tail)?])));
    ends.map(|(bone, ends)| (bone.name.clone(), ends)).collect()
}

fn mean(points: &[Point]) -> Point {
    let sum = points.iter().fold([0.0; 3], |sum: Point, point| [0, 1, 2].map(|axis| sum[axis] + point[axis]));
    sum.map(|sum| sum / points.len() as f32)
}

/// The square of the distance of a point from a segment.
fn from_segment(point: Point, head: Point, tail: Point) -> f32 {
    let minus = |a: Point, b: Point| [0, 1, 2].map(|axis| a[axis] - b[axis]);
    let dot = |a: Point, b: Point| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
    let (along, to) = (minus(tail, head), minus(point, head));
    let length = dot(along, along);
    let share = if length > 0.0 { (dot(to, along) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = minus(to, along.map(|part| part * share));
    dot(off, off)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::{mhskel, obj};
    use crate::json;

    #[test]
    fn a_vertex_is_told_by_its_group_and_the_nearest_bone() {
        let mesh =
            obj::parse(b"v 0 0 0\nv 0 4 0\nv 5 4 0\nv 1 1 0\nv 4 5 0\nv 9 9 9\ng arm\nf 1 4 2\ng hand\nf 2 5 3\n");
        let text = br#"{"joints": {"a": [0], "b": [1], "c": [2], "d": [77]}, "bones": {
            "upper": {"head": "a", "tail": "b", "parent": null},
            "lower": {"head": "b", "tail": "c", "parent": "upper"},
            "lost": {"head": "c", "tail": "d", "parent": "lower"}}}"#;
        let skeleton = mhskel::read(&json::parse(text).unwrap());
        let landmarks = Landmarks::of(&mesh, Some(&skeleton));
        let told = [3, 4, 5, 99].map(|vertex| landmarks.place(&mesh, vertex));
        let expected = [Some("`arm`, near `upper`"), Some("`hand`, near `lower`"), Some("near `lower`"), None];
        assert_eq!(told, expected.map(|text| text.map(str::to_owned)));
        assert_eq!(Landmarks::of(&mesh, None).place(&mesh, 5), None);
    }
}
