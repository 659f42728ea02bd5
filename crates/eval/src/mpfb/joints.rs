//! Where bones begin and end on a mesh. Blender stores places as 32 bit floats.
//!
//! Source: MPFB, strategies of rigs (`docs/loaders/mpfb/rigs.md#positions`).

use std::collections::BTreeMap;

use crate::vector::{Point, Vec3, add, narrow, scale, widen};

/// A mesh with what ends of bones refer to, in Blender's axes.
#[derive(Debug, Clone)]
pub struct Joints<'a> {
    positions: &'a [Point],
    cubes: BTreeMap<&'a str, Option<Vec3>>,
}

/// How the place of an end is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strategy<'a> {
    /// Mean of the vertices of a joint.
    Cube(&'a str),
    /// A vertex; negative ones count from the end.
    Vertex(i64),
    /// Mean of some; one that is listed twice counts twice.
    Mean(&'a [i64]),
    /// x of the first, y of the second, z of the third.
    Xyz(&'a [i64]),
    /// In no way.
    None,
}

/// An end of a bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoneEnd<'a> {
    /// How its place is found.
    pub strategy: Strategy<'a>,
    /// What is added to it.
    pub offset: Vec3,
    /// Where it is otherwise.
    pub default_position: Option<Vec3>,
}

/// Where an end is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Located {
    /// Where its strategy says.
    Found(Vec3),
    /// At its default position.
    Default(Vec3),
    /// Nowhere: no rig is made.
    Nowhere,
}

impl Located {
    /// The place, whichever way it was found.
    pub const fn place(self) -> Option<Vec3> {
        match self {
            Self::Found(place) | Self::Default(place) => Some(place),
            Self::Nowhere => None,
        }
    }
}

impl<'a> Joints<'a> {
    /// A mesh with its joints: names, and first and last vertices of each, both included.
    pub fn new(
        positions: &'a [Point],
        groups: impl IntoIterator<Item = (&'a str, &'a [(i64, i64)])>,
    ) -> Self {
        let groups = groups
            .into_iter()
            .filter(|(name, _)| name.contains("joint"));
        let cubes = groups
            .map(|(name, ranges)| (name, middle(positions, ranges)))
            .collect();
        Self { positions, cubes }
    }

    /// The place of a joint; none of one that does not exist or has no vertex.
    pub fn cube(&self, name: &str) -> Option<Vec3> {
        self.cubes.get(name).copied().flatten()
    }

    /// Names of all joints.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        self.cubes.keys().copied()
    }

    /// Where an end is. `relative_scale` is the scale of the mesh by that at which offsets were
    /// recorded.
    pub fn locate(&self, end: &BoneEnd<'_>, relative_scale: f64) -> Located {
        match (self.by_strategy(end.strategy), end.default_position) {
            (Some(place), _) => {
                Located::Found(widen(narrow(add(place, scale(end.offset, relative_scale)))))
            }
            (None, Some(place)) => Located::Default(place),
            (None, None) => Located::Nowhere,
        }
    }

    fn by_strategy(&self, strategy: Strategy<'_>) -> Option<Vec3> {
        match strategy {
            Strategy::Cube(name) => self.cube(name),
            Strategy::Vertex(vertex) => self.vertex(vertex),
            Strategy::Mean(vertices) => mean(vertices.iter().map(|vertex| self.vertex(*vertex))),
            Strategy::Xyz(vertices) => {
                let places: Option<Vec<Vec3>> =
                    vertices.iter().map(|vertex| self.vertex(*vertex)).collect();
                match places?.as_slice() {
                    [x, y, z, ..] => Some([x[0], y[1], z[2]]),
                    _ => None,
                }
            }
            Strategy::None => None,
        }
    }

    fn vertex(&self, vertex: i64) -> Option<Vec3> {
        let count = i64::try_from(self.positions.len()).ok()?;
        let at = if vertex < 0 {
            vertex.checked_add(count)?
        } else {
            vertex
        };
        self.positions
            .get(usize::try_from(at).ok()?)
            .copied()
            .map(widen)
    }
}

/// Mean of the vertices in ranges, as far as they exist.
fn middle(positions: &[Point], ranges: &[(i64, i64)]) -> Option<Vec3> {
    let clamp = |at: i64| {
        usize::try_from(at.max(0))
            .unwrap_or(usize::MAX)
            .min(positions.len())
    };
    let of_range = |(first, last): &(i64, i64)| {
        clamp(*first)..clamp(last.saturating_add(1)).max(clamp(*first))
    };
    let all = ranges
        .iter()
        .flat_map(|range| positions.get(of_range(range)).unwrap_or_default());
    mean(all.map(|point| Some(widen(*point))))
}

/// Mean of places; none if one of them is missing, or all are.
fn mean(places: impl Iterator<Item = Option<Vec3>>) -> Option<Vec3> {
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for place in places {
        sum = add(sum, place?);
        count += 1.0;
    }
    (count > 0.0).then(|| scale(sum, 1.0 / count))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [Point; 4] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 4.0],
    ];

    fn locate(strategy: Strategy<'_>) -> Located {
        let ranges = [(0, 1)];
        let joints = Joints::new(
            &MESH,
            [
                ("joint-a", &ranges[..]),
                ("joint-empty", &[(9, 12)]),
                ("body", &[(0, 3)]),
            ],
        );
        let end = BoneEnd {
            strategy,
            offset: [0.0, 0.0, 2.0],
            default_position: Some([9.0; 3]),
        };
        joints.locate(&end, 0.5)
    }

    #[test]
    fn offsets_are_scaled_and_belong_to_what_is_found() {
        assert_eq!(
            locate(Strategy::Cube("joint-a")),
            Located::Found([0.5, 0.0, 1.0])
        );
        assert_eq!(
            locate(Strategy::Vertex(-1)),
            Located::Found([0.0, 2.0, 5.0])
        );
        assert_eq!(
            locate(Strategy::Mean(&[0, 1, 1, 0])),
            Located::Found([0.5, 0.0, 1.0])
        );
        assert_eq!(
            locate(Strategy::Xyz(&[1, 2, 3, 0])),
            Located::Found([1.0, 2.0, 5.0])
        );
        let nothing = [
            Strategy::Cube("joint-empty"),
            Strategy::Cube("body"),
            Strategy::Vertex(4),
            Strategy::Vertex(-5),
            Strategy::Mean(&[]),
            Strategy::Mean(&[0, 4]),
            Strategy::Xyz(&[0, 1]),
            Strategy::Xyz(&[0, 1, 2, 4]),
            Strategy::None,
        ];
        assert!(
            nothing
                .into_iter()
                .all(|strategy| locate(strategy) == Located::Default([9.0; 3]))
        );
    }

    #[test]
    fn without_a_default_there_is_no_place() {
        let end = BoneEnd {
            strategy: Strategy::None,
            offset: [0.0; 3],
            default_position: None,
        };
        assert_eq!(Joints::new(&MESH, []).locate(&end, 1.0).place(), None);
    }
}
