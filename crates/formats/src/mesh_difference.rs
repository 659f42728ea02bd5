//! How two meshes differ for those who see them: not in the order of faces, nor in the last digit
//! of a position.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::obj::{Face, Mesh};
use super::stored;

/// Vertices that are nearer to one another than this, mesh units, are in one place: exporters write
/// four decimals.
const SAME_PLACE: f32 = 0.0001;
/// Texture coordinates that are nearer than this are the same: those nearer than half of it are
/// joined when a mesh is packed.
const SAME_UV: f32 = 0.002;

/// How one mesh differs from another.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MeshDifference {
    /// Numbers of vertices of both, where they are not the same. Nothing can be said of single
    /// vertices and faces then.
    pub vertices: Option<[usize; 2]>,
    /// Vertices that lie elsewhere.
    pub moved: usize,
    /// The one of these that is farthest away, and how far.
    pub farthest: Option<(u32, f32)>,
    /// Numbers of faces of both, where they are not the same.
    pub faces: Option<[usize; 2]>,
    /// Faces of the first that the other has not, where it has as many.
    pub other_faces: usize,
    /// Groups with faces that the other has not, of the first and of the second.
    pub groups: [Vec<String>; 2],
    /// Faces that are in another group, where both have the same groups.
    pub regrouped: usize,
    /// Faces with other texture coordinates.
    pub retextured: usize,
}

impl MeshDifference {
    /// How `one` differs from `other`.
    pub fn between(one: &Mesh, other: &Mesh) -> Self {
        let unlike = |counts: [usize; 2]| (counts[0] != counts[1]).then_some(counts);
        let mut found = Self {
            vertices: unlike([one.positions.len(), other.positions.len()]),
            faces: unlike([one.faces.len(), other.faces.len()]),
            groups: [missing(one, other), missing(other, one)],
            ..Self::default()
        };
        if found.vertices.is_none() {
            found.compare_positions(one, other);
            found.compare_faces(&Outline::of_all(one), &Outline::of_all(other));
        }
        found
    }

    /// Whether they are the same.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Positions that are no number are a fault of their own.
    fn compare_positions(&mut self, one: &Mesh, other: &Mesh) {
        for (vertex, (a, b)) in (0..).zip(one.positions.iter().zip(&other.positions)) {
            let distance = distance(a, b);
            if distance.is_finite() && distance >= SAME_PLACE {
                self.moved += 1;
                if self.farthest.is_none_or(|(_, most)| distance > most) {
                    self.farthest = Some((vertex, distance));
                }
            }
        }
    }

    fn compare_faces(&mut self, one: &[Outline<'_>], other: &[Outline<'_>]) {
        let has_same_groups = self.groups.iter().all(Vec::is_empty);
        let (mut own, mut others) = (one.iter().peekable(), other.iter().peekable());
        while let Some(face) = own.peek() {
            match others
                .peek()
                .map_or(Ordering::Less, |other| face.corners.cmp(&other.corners))
            {
                Ordering::Less => {
                    self.other_faces += usize::from(self.faces.is_none());
                    own.next();
                }
                Ordering::Greater => drop(others.next()),
                Ordering::Equal => {
                    if let (Some(face), Some(other)) = (own.next(), others.next()) {
                        self.regrouped += usize::from(has_same_groups && face.group != other.group);
                        self.retextured += usize::from(!face.is_textured_as(other));
                    }
                }
            }
        }
    }
}

fn distance(a: &[f32; 3], b: &[f32; 3]) -> f32 {
    let square = |(a, b): (&f32, &f32)| (f64::from(*a) - f64::from(*b)).powi(2);
    stored(a.iter().zip(b).map(square).sum::<f64>().sqrt())
}

/// Groups with faces that the other mesh has not.
fn missing(one: &Mesh, other: &Mesh) -> Vec<String> {
    let others: BTreeSet<&str> = groups_with_faces(other).collect();
    groups_with_faces(one)
        .filter(|name| !others.contains(name))
        .map(str::to_owned)
        .collect()
}

fn groups_with_faces(mesh: &Mesh) -> impl Iterator<Item = &str> {
    mesh.groups
        .iter()
        .filter(|group| group.faces > 0)
        .map(|group| group.name.as_str())
}

/// A face from its lowest vertex on, whichever of its corners came first.
struct Outline<'m> {
    corners: Vec<u32>,
    group: &'m str,
    uvs: Vec<Option<[f32; 2]>>,
}

impl<'m> Outline<'m> {
    fn of_all(mesh: &'m Mesh) -> Vec<Self> {
        let mut outlines: Vec<Self> = mesh
            .faces
            .iter()
            .map(|face| Self::of(mesh, *face))
            .collect();
        outlines.sort_by(|a, b| a.corners.cmp(&b.corners).then_with(|| a.group.cmp(b.group)));
        outlines
    }

    fn of(mesh: &'m Mesh, face: Face) -> Self {
        let mut corners = face.of(&mesh.corners).to_vec();
        let mut uvs: Vec<_> = face
            .of(&mesh.corner_uvs)
            .iter()
            .map(|uv| mesh.uvs.get(*uv as usize).copied())
            .collect();
        let lowest = (0..corners.len())
            .min_by_key(|at| corners.get(*at))
            .unwrap_or_default();
        corners.rotate_left(lowest);
        if uvs.len() == corners.len() {
            uvs.rotate_left(lowest);
        }
        let group = mesh
            .groups
            .get(face.group as usize)
            .map_or("", |group| group.name.as_str());
        Self {
            corners,
            group,
            uvs,
        }
    }

    fn is_textured_as(&self, other: &Self) -> bool {
        self.uvs.len() == other.uvs.len()
            && self.uvs.iter().zip(&other.uvs).all(|pair| match pair {
                (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME_UV),
                (a, b) => a.is_none() == b.is_none(),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::obj;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    const FACES: &str = "g a\nf 1/1 2/2 3/3\ng b\nf 1/1 3/3 4/4\n";

    fn between(one: &str, other: &str) -> MeshDifference {
        MeshDifference::between(&obj::parse(one.as_bytes()), &obj::parse(other.as_bytes()))
    }

    /// How the square differs from it with its positions or faces replaced.
    fn replaced(find: &str, by: &str) -> MeshDifference {
        let text = format!("{SQUARE}{FACES}");
        assert!(text.contains(find));
        between(&text, &text.replacen(find, by, 1))
    }

    #[test]
    fn order_and_the_last_digit_make_no_difference() {
        assert!(replaced("v 0 0 0", "v 0 0 0.00009").is_none());
        assert!(replaced("f 1/1 2/2 3/3", "f 2/2 3/3 1/1").is_none());
        assert!(replaced("vt 0 0", "vt 0.0019 0").is_none());
        let swapped = format!("{SQUARE}g b\nf 3/3 4/4 1/1\ng c\ng a\nf 1/1 2/2 3/3\n");
        assert!(between(&format!("{SQUARE}{FACES}"), &swapped).is_none());
    }

    #[test]
    fn what_is_seen_is_named() {
        let moved = replaced("v 0 0 0", "v 0 0 0.0002");
        assert_eq!(
            (moved.moved, moved.farthest.map(|(vertex, _)| vertex)),
            (1, Some(0))
        );
        let far = MeshDifference {
            farthest: Some((2, 3.0)),
            moved: 1,
            ..MeshDifference::default()
        };
        assert_eq!(replaced("v 1 1 0", "v 1 4 0"), far);
        assert_eq!(replaced("f 1/1 2/2 3/3", "f 1/1 3/3 2/2").other_faces, 1);
        assert_eq!(
            replaced("f 1/1 2/2 3/3\n", "f 1/1 2/2 3/3\nf 2/2 3/3 4/4\n").faces,
            Some([2, 3])
        );
        assert_eq!(
            replaced("g a", "g c").groups,
            [["a".to_owned()], ["c".to_owned()]]
        );
        assert_eq!(
            replaced("g b\nf 1/1 3/3 4/4", "f 1/1 3/3 4/4\ng b\nf 2/2 3/3 4/4").regrouped,
            1
        );
        assert_eq!(replaced("vt 0 0", "vt 0.1 0").retextured, 2);
        assert_eq!(replaced("f 1/1 2/2 3/3", "f 1 2 3").retextured, 1);
    }

    #[test]
    fn with_other_numbers_of_vertices_there_is_no_more_to_say() {
        let found = replaced("v 0 0 0", "v 9 9 9\nv 0 0 0");
        assert_eq!(
            found,
            MeshDifference {
                vertices: Some([4, 5]),
                ..MeshDifference::default()
            }
        );
    }

    #[test]
    fn positions_that_are_no_number_are_passed_over() {
        assert!(replaced("v 0 0 0", "v nan 0 0").is_none());
    }
}
