//! Displacements out of all proportion to their mesh and their target.
//!
//! Gets a few numbers of a target, says whether its longest displacement can be meant. Used where
//! such targets are reported and where they would spoil everything else that is measured.

use std::collections::BTreeMap;

use super::mesh::bounding_box;
use super::tears::{Neighbours, length};
use super::vector::Point;

/// How many times its target's median displacement a vertex may move, unless somebody says
/// otherwise.
pub const MEDIAN_RATIO: f32 = 20.0;
/// Share of the mesh's size below which nothing is oversized: no detail of a face is torn by less.
const SMALLEST_SHARE: f32 = 0.05;
/// How many times the length that all but the longest rows keep an outlier must have. In shipped
/// targets the longest row is at most twice as long.
const ISOLATION: f32 = 4.0;

/// How many times as far as any other detail of its folder a detail may move. In shipped folders it
/// is 3.7 at most.
const NEIGHBOUR_RATIO: f32 = 5.0;

/// Whether a detail stands out of its folder as a whole: by its longest displacement and by that of
/// half of its rows. `next` has the largest of both among the others.
pub fn stands_out_of_folder(own: Lengths, next: Lengths, size: f32) -> bool {
    next.longest > 0.0
        && own.longest > NEIGHBOUR_RATIO * next.longest
        && own.median > NEIGHBOUR_RATIO * next.median
        && own.longest > SMALLEST_SHARE * size
}

/// How many times as far as the other end of its slider a target may move. In shipped data it is
/// 6.4 at most, and 5.8 by the displacement of half of the rows.
const OPPOSITE_RATIO: f32 = 8.0;

/// Whether a target is of another scale than the one at the other end of its slider.
pub fn is_out_of_scale(own: Lengths, other: Lengths) -> bool {
    other.longest > 0.0
        && own.longest > OPPOSITE_RATIO * other.longest
        && own.median > NEIGHBOUR_RATIO * other.median
}

/// Lengths of the displacements of a target, mesh units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lengths {
    /// The longest.
    pub longest: f32,
    /// Half are longer.
    pub median: f32,
    /// What all but the longest few keep.
    pub tail: f32,
}

/// Why a displacement is out of proportion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Oversize {
    /// Farther than the mesh is large.
    BeyondMesh,
    /// It stands out of its own target.
    Outlier,
}

/// Judges the longest displacement; `size` is the longest side of the mesh, `ratio` as
/// [`MEDIAN_RATIO`].
pub fn oversize(lengths: Lengths, size: f32, ratio: f32) -> Option<Oversize> {
    let Lengths {
        longest,
        median,
        tail,
    } = lengths;
    if longest > size {
        return Some(Oversize::BeyondMesh);
    }
    let stands_out = is_far(longest, median, size, ratio) && longest > ISOLATION * tail;
    stands_out.then_some(Oversize::Outlier)
}

/// Whether a displacement is far from half of the others, and considerable for the mesh.
fn is_far(length: f32, median: f32, size: f32, ratio: f32) -> bool {
    length > ratio * median && length > SMALLEST_SHARE * size
}

/// Whether the longest displacement of a target leaves those of its neighbours in the mesh.
/// `longest` has all that are longer than `tail`; `index` is the vertex.
pub fn is_torn_out(
    longest: &[(u32, Point)],
    tail: f32,
    index: i64,
    neighbours: &Neighbours,
) -> bool {
    let Ok(index) = u32::try_from(index) else {
        return true;
    };
    // Of a vertex with several rows the last one counts.
    let moved: BTreeMap<u32, Point> = longest
        .iter()
        .copied()
        .filter(|(_, way)| length(*way) > tail)
        .collect();
    let vertices = moved.keys().copied().collect();
    !moved.contains_key(&index)
        || neighbours
            .torn(&vertices, tail, |vertex| moved.get(&vertex).copied())
            .contains(&index)
}

/// The vertices whose displacement would stand out if the longer ones were as they should be.
pub fn standing_out(
    longest: &[(u32, Point)],
    median: f32,
    size: f32,
    ratio: f32,
) -> impl Iterator<Item = u32> {
    longest
        .iter()
        .filter(move |(_, way)| is_far(length(*way), median, size, ratio))
        .map(|(vertex, _)| *vertex)
}

/// The longest side of the box around the mesh; `None` without vertices or extent.
pub fn extent(positions: &[Point]) -> Option<f32> {
    let finite = |point: &&Point| point.iter().all(|part| part.is_finite());
    let finite: Vec<Point> = positions.iter().filter(finite).copied().collect();
    let (low, high) = bounding_box(&finite)?;
    let size = low
        .iter()
        .zip(high)
        .map(|(low, high)| high - low)
        .fold(0.0, f32::max);
    (size > 0.0).then_some(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTHS: Lengths = Lengths {
        longest: 1.0,
        median: 0.04,
        tail: 0.2,
    };

    #[test]
    fn a_lonely_long_row_stands_out() {
        assert_eq!(
            oversize(LENGTHS, 10.0, MEDIAN_RATIO),
            Some(Oversize::Outlier)
        );
        for lengths in [
            Lengths {
                median: 0.06,
                ..LENGTHS
            },
            Lengths {
                tail: 0.3,
                ..LENGTHS
            },
            Lengths {
                longest: 0.4,
                median: 0.01,
                tail: 0.01,
            },
        ] {
            assert_eq!(oversize(lengths, 10.0, MEDIAN_RATIO), None, "{lengths:?}");
        }
    }

    #[test]
    fn a_detail_stands_out_of_its_folder_by_ratio_and_size() {
        let lengths = |longest, median| Lengths {
            longest,
            median,
            tail: longest,
        };
        let next = lengths(0.2, 0.1);
        assert!(stands_out_of_folder(lengths(1.1, 0.6), next, 10.0));
        assert!(!stands_out_of_folder(lengths(1.0, 0.6), next, 10.0));
        assert!(!stands_out_of_folder(lengths(1.1, 0.5), next, 10.0));
        assert!(!stands_out_of_folder(
            lengths(0.5, 0.4),
            lengths(0.01, 0.01),
            10.0
        ));
        assert!(!stands_out_of_folder(
            lengths(1.1, 0.6),
            lengths(0.0, 0.0),
            10.0
        ));
    }

    #[test]
    fn nothing_moves_farther_than_the_mesh_is_large() {
        let wide = Lengths {
            longest: 3.0,
            median: 3.0,
            tail: 3.0,
        };
        assert_eq!(
            oversize(wide, 2.0, MEDIAN_RATIO),
            Some(Oversize::BeyondMesh)
        );
        assert_eq!(oversize(wide, 4.0, MEDIAN_RATIO), None);
    }

    #[test]
    fn extent_is_the_longest_side() {
        assert_eq!(
            extent(&[[0.0; 3], [1.0, 3.0, 2.0], [f32::NAN; 3]]),
            Some(3.0)
        );
        assert_eq!(extent(&[[1.0; 3]]), None);
    }
}
