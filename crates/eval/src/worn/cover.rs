//! Hidden parts of the wearer that nothing of the asset covers.

use super::triangles::Triangles;
use super::{Garment, Wearer};
use crate::faces::{mean, middle_of, vector_of};
use crate::vector::{Point, Vec3, length, scale, sub};

/// Parts of the wearer's height. How far below the skin an asset may lie and cover it (5 cm on
/// hm08).
const BELOW: f64 = 0.03;
/// How far it may be away in front of it: the wide skirt of a dress covers the legs.
const IN_FRONT: f64 = 0.5;
/// A face as near to the asset as this is at its hem (5 cm on hm08). Those of MakeHuman's clothes
/// come to 4 cm.
const HEM: f64 = 0.03;
/// The size of cells to sort the triangles into.
const CELL: f64 = 0.02;
/// Faces that look down as much as this are seen by nobody who stands on the same ground.
const DOWN: f64 = -0.7;
/// A single face is no hole.
const FEWEST: usize = 2;
/// More hidden faces are not looked at one by one.
const MOST: usize = 1 << 16;

/// Hidden faces that are not covered.
#[derive(Debug, Clone, PartialEq)]
pub struct Uncovered {
    /// How many.
    pub count: usize,
    /// How many are hidden.
    pub hidden: usize,
    /// How many there are.
    pub shown: usize,
    /// A vertex of each, in order.
    pub vertices: Vec<u32>,
    /// A vertex of the one that is farthest from the others' edge: the middle of the hole.
    pub middle: u32,
}

/// Hidden faces of the skin in front of which there is nothing of the asset. `None` where all are
/// covered, or none hidden.
pub(super) fn uncovered(
    wearer: &Wearer<'_>,
    garment: &Garment<'_>,
    fitted: &[Point],
) -> Option<Uncovered> {
    let is_deleted = |vertex: &u32| garment.deleted.get(*vertex as usize) == Some(&true);
    let skin = wearer.skin.below(wearer.positions.len());
    let hidden: Vec<&[u32]> = skin
        .filter(|face| face.iter().all(is_deleted))
        .take(MOST)
        .collect();
    if hidden.is_empty() {
        return None;
    }
    let triangles = Triangles::of(fitted, garment.faces, wearer.height * CELL)?;
    let bare: Vec<&[u32]> = hidden
        .iter()
        .copied()
        .filter(|face| is_bare(wearer, face, &triangles))
        .collect();
    let mut vertices: Vec<u32> = bare
        .iter()
        .filter_map(|face| face.first().copied())
        .collect();
    vertices.sort_unstable();
    vertices.dedup();
    let middle = middle(wearer, &bare)?;
    let shown = wearer.skin.below(wearer.positions.len()).count();
    (bare.len() >= FEWEST).then_some(Uncovered {
        count: bare.len(),
        hidden: hidden.len(),
        shown,
        vertices,
        middle,
    })
}

fn is_bare(wearer: &Wearer<'_>, face: &[u32], triangles: &Triangles) -> bool {
    let middle = middle_of(face, wearer.positions);
    let vector = vector_of(face, wearer.positions);
    let direction = scale(vector, 1.0 / length(vector));
    if direction.iter().any(|part| !part.is_finite()) || direction[1] < DOWN {
        return false;
    }
    let from = sub(middle, scale(direction, wearer.height * BELOW));
    !triangles.crosses(from, direction, wearer.height * (BELOW + IN_FRONT))
        && !triangles.is_within(middle, wearer.height * HEM)
}

/// A vertex of the face nearest to the middle of all.
fn middle(wearer: &Wearer<'_>, faces: &[&[u32]]) -> Option<u32> {
    let middles: Vec<Vec3> = faces
        .iter()
        .map(|face| middle_of(face, wearer.positions))
        .collect();
    let whole = mean(middles.iter().copied());
    let away = |at: &usize| {
        middles
            .get(*at)
            .map_or(f64::MAX, |middle| length(sub(*middle, whole)))
    };
    let nearest = (0..faces.len()).min_by(|one, other| away(one).total_cmp(&away(other)))?;
    faces.get(nearest)?.first().copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::Faces;
    use crate::fit::Reference;

    /// A wall of 20 by 20 squares that looks along z, and the same over it.
    fn wall(z: f32) -> Vec<Point> {
        (0..441_u16)
            .map(|at| [f32::from(at % 21), f32::from(at / 21), z])
            .collect()
    }

    fn faces(keep: impl Fn(u32) -> bool) -> (Vec<u32>, Vec<u32>) {
        let squares = (0..400_u32)
            .filter(|at| keep(*at))
            .map(|at| at / 20 * 21 + at % 20);
        let corners: Vec<u32> = squares
            .flat_map(|first| [first, first + 1, first + 22, first + 21])
            .collect();
        let starts = (0..).step_by(4).take(corners.len() / 4 + 1).collect();
        (corners, starts)
    }

    fn bare(
        over: f32,
        keep: impl Fn(u32) -> bool,
        deleted: impl Fn(usize) -> bool,
    ) -> Option<Uncovered> {
        let (skin, skin_starts) = faces(|_| true);
        let (own, own_starts) = faces(keep);
        let positions = wall(0.0);
        let deleted: Vec<bool> = (0..441).map(deleted).collect();
        let wearer = Wearer {
            positions: &positions,
            skin: Faces {
                corners: &skin,
                starts: &skin_starts,
            },
            height: 20.0,
        };
        let references: Vec<Reference> = Vec::new();
        let garment = Garment {
            references: &references,
            scales: None,
            drawn: &[],
            faces: Faces {
                corners: &own,
                starts: &own_starts,
            },
            deleted: &deleted,
        };
        uncovered(&wearer, &garment, &wall(over))
    }

    #[test]
    fn what_lies_under_the_asset_is_covered() {
        assert_eq!(bare(0.3, |_| true, |_| true), None);
        assert_eq!(bare(9.0, |_| true, |_| true), None);
        assert_eq!(bare(-0.5, |_| true, |_| true), None);
        assert_eq!(bare(0.3, |_| false, |_| false), None);
    }

    #[test]
    fn a_hole_is_found_with_its_middle() {
        // The upper half has no asset; the row of faces above its edge is near enough.
        let found = bare(0.3, |face| face < 200, |_| true).unwrap();
        assert_eq!((found.count, found.hidden), (180, 400));
        assert!((315..336).contains(&found.middle), "{found:?}");
        // Too far away in front, or behind.
        assert_eq!(bare(10.5, |_| true, |_| true).unwrap().count, 400);
        assert_eq!(bare(-0.7, |_| true, |_| true).unwrap().count, 400);
    }

    #[test]
    fn a_single_face_and_a_hem_are_no_hole() {
        assert_eq!(
            bare(0.3, |face| face % 20 < 10, |vertex| vertex % 21 < 11),
            None
        );
        assert_eq!(
            bare(0.3, |_| false, |_| true),
            None,
            "an asset without faces has a finding of its own"
        );
        let corner = |vertex: usize| matches!(vertex, 439 | 440 | 418 | 419);
        assert_eq!(bare(0.3, |face| face < 20, corner), None);
    }
}
