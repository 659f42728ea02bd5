//! The outside of a set of grid cells as quads: a closed surface whose vertices are grid points.
//!
//! Gets cells, returns points (sorted by height, depth, side) and quads of point numbers that turn
//! outwards. As long as no two cells touch only along an edge or in a corner, the surface is
//! manifold. It knows nothing about bodies.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Whole-number grid point, also the lower corner of a cell: side, height, depth.
pub(crate) type GridPoint = (i32, i32, i32);

pub(crate) struct Surface {
    pub(crate) points: Vec<GridPoint>,
    pub(crate) quads: Vec<[usize; 4]>,
}

/// A direction and the four corners of that side of a cell, counter-clockwise seen from outside.
const SIDES: [(GridPoint, [GridPoint; 4]); 6] = [
    ((1, 0, 0), [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)]),
    ((-1, 0, 0), [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)]),
    ((0, 1, 0), [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)]),
    ((0, -1, 0), [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]),
    ((0, 0, 1), [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]),
    ((0, 0, -1), [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)]),
];

/// A box of cells and its mirror image on the other side of the centre plane.
pub(crate) fn add_mirrored(
    cells: &mut BTreeSet<GridPoint>,
    side: Range<i32>,
    height: Range<i32>,
    depth: Range<i32>,
) {
    for i in side {
        for j in height.clone() {
            for k in depth.clone() {
                cells.insert((i, j, k));
                cells.insert((-1 - i, j, k));
            }
        }
    }
}

pub(crate) fn surface(cells: &BTreeSet<GridPoint>) -> Surface {
    let mut corners = Vec::new();
    for &cell in cells {
        for (direction, side) in SIDES {
            if !cells.contains(&sum(cell, direction)) {
                corners.push(side.map(|corner| sum(cell, corner)));
            }
        }
    }
    let sorted: BTreeSet<(i32, i32, i32)> = corners
        .iter()
        .flatten()
        .map(|&(i, j, k)| (j, k, i))
        .collect();
    let points: Vec<GridPoint> = sorted.into_iter().map(|(j, k, i)| (i, j, k)).collect();
    let numbers: BTreeMap<GridPoint, usize> = points
        .iter()
        .enumerate()
        .map(|(at, &point)| (point, at))
        .collect();
    let quads = corners
        .iter()
        .map(|quad| quad.map(|corner| numbers[&corner]))
        .collect();
    Surface { points, quads }
}

fn sum(a: GridPoint, b: GridPoint) -> GridPoint {
    (a.0 + b.0, a.1 + b.1, a.2 + b.2)
}
