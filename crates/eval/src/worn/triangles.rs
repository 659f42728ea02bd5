//! Triangles by place.

use super::closest::from_triangle;
use crate::faces::{Faces, fan};
use crate::lists::Lists;
use crate::steps::step;
use crate::vector::{Point, Vec3, add, cross, dot, scale, sub, widen};

/// A triangle over more cells than this is looked at always.
const LARGE: i64 = 256;
/// More of these are not searched.
const MOST_LARGE: usize = 64;
/// Cells along a side of the box at most.
const MOST_CELLS: f64 = 64.0;

/// Triangles sorted into the cells of a box.
pub(super) struct Triangles {
    all: Vec<[Vec3; 3]>,
    low: Vec3,
    cell: f64,
    counts: [i64; 3],
    cells: Lists<u32>,
    large: Vec<u32>,
}

type Cell = [i64; 3];

impl Triangles {
    /// The finite triangles of faces. `None` without any, and where there are too many large ones.
    pub(super) fn of(positions: &[Point], faces: Faces<'_>, cell: f64) -> Option<Self> {
        let corner = |vertex: u32| {
            positions
                .get(vertex as usize)
                .map_or([f64::NAN; 3], |point| widen(*point))
        };
        let all = faces
            .below(positions.len())
            .flat_map(fan)
            .map(|triangle| triangle.map(corner));
        let all: Vec<[Vec3; 3]> = all
            .filter(|one| one.iter().flatten().all(|part| part.is_finite()))
            .collect();
        let (low, high) =
            all.iter()
                .flatten()
                .fold(([f64::MAX; 3], [f64::MIN; 3]), |(low, high), point| {
                    (
                        [0, 1, 2].map(|axis| point[axis].min(low[axis])),
                        [0, 1, 2].map(|axis| point[axis].max(high[axis])),
                    )
                });
        let longest = sub(high, low).into_iter().fold(0.0, f64::max);
        let cell = cell.max(longest / MOST_CELLS);
        if all.is_empty() || !(cell > 0.0) {
            return None;
        }
        let mut triangles = Self {
            all,
            low,
            cell,
            counts: [0; 3],
            cells: Lists::default(),
            large: Vec::new(),
        };
        triangles.counts = triangles.cell_of(high).map(|last| last + 1);
        triangles.sort();
        (triangles.large.len() <= MOST_LARGE).then_some(triangles)
    }

    fn sort(&mut self) {
        let mut placed: Vec<(usize, u32)> = Vec::new();
        let mut large = Vec::new();
        for (number, triangle) in (0..).zip(&self.all) {
            let [low, high] = self.range(triangle);
            let span = [0, 1, 2].map(|axis| high[axis] - low[axis] + 1);
            if span.iter().product::<i64>() > LARGE {
                large.push(number);
            } else {
                placed.extend(self.between(low, high).map(|cell| (cell, number)));
            }
        }
        let cells = self.counts.iter().product::<i64>();
        self.cells = Lists::new(
            usize::try_from(cells).unwrap_or_default(),
            placed.iter().copied(),
        );
        self.large = large;
    }

    fn range(&self, points: &[Vec3]) -> [Cell; 2] {
        let end = |best: fn(f64, f64) -> f64| {
            let point = points
                .iter()
                .copied()
                .reduce(|one, other| [0, 1, 2].map(|axis| best(one[axis], other[axis])));
            self.cell_of(point.unwrap_or_default())
        };
        [end(f64::min), end(f64::max)]
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "saturates, and is bounded where it is used"
    )]
    fn cell_of(&self, point: Vec3) -> Cell {
        [0, 1, 2].map(|axis| ((point[axis] - self.low[axis]) / self.cell).floor() as i64)
    }

    /// The numbers of the cells of a range that are in the box.
    fn between(&self, low: Cell, high: Cell) -> impl Iterator<Item = usize> + use<> {
        let [x, y, z] =
            [0, 1, 2].map(|axis| low[axis].max(0)..=high[axis].min(self.counts[axis] - 1));
        let [_, columns, rows] = self.counts;
        let plane = x.flat_map(move |x| y.clone().map(move |y| x * columns + y));
        plane
            .flat_map(move |xy| z.clone().map(move |z| xy * rows + z))
            .filter_map(|cell| usize::try_from(cell).ok())
    }

    /// Those that may be near a stretch, some of them several times.
    fn near(&self, from: Vec3, to: Vec3) -> impl Iterator<Item = &[Vec3; 3]> {
        let [low, high] = self.range(&[from, to]);
        let cells = self.between(low, high).flat_map(|cell| self.cells.of(cell));
        cells
            .chain(&self.large)
            .filter_map(|number| self.all.get(*number as usize))
            .inspect(|_| step())
    }

    /// Whether a point is as near to a triangle as this.
    pub(super) fn is_within(&self, point: Vec3, reach: f64) -> bool {
        let corner = [reach; 3];
        self.near(sub(point, corner), add(point, corner))
            .any(|triangle| from_triangle(point, *triangle) <= reach)
    }

    /// Whether a triangle crosses the stretch from a point in a direction, in pieces of a cell's
    /// length.
    pub(super) fn crosses(&self, from: Vec3, direction: Vec3, length: f64) -> bool {
        let mut at = 0.0;
        while at < length {
            let end = (at + self.cell).min(length);
            let piece = [at, end].map(|along| add(from, scale(direction, along)));
            if self
                .near(piece[0], piece[1])
                .any(|triangle| is_hit(from, direction, length, triangle))
            {
                return true;
            }
            at = end;
        }
        false
    }
}

/// Whether a ray of this length meets a triangle, its edges included (Möller and Trumbore 1997).
fn is_hit(from: Vec3, direction: Vec3, length: f64, [first, second, third]: &[Vec3; 3]) -> bool {
    const EDGE: f64 = 1e-3;
    let (one, other) = (sub(*second, *first), sub(*third, *first));
    let across = cross(direction, other);
    let determinant = dot(one, across);
    if determinant == 0.0 {
        return false;
    }
    let off = sub(from, *first);
    let of_one = dot(off, across) / determinant;
    let turned = cross(off, one);
    let of_other = dot(direction, turned) / determinant;
    let along = dot(other, turned) / determinant;
    let is_inside = of_one >= -EDGE && of_other >= -EDGE && of_one + of_other <= 1.0 + EDGE;
    is_inside && (0.0..=length).contains(&along)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A floor of 10 by 10 squares.
    fn floor() -> (Vec<Point>, Vec<u32>, Vec<u32>) {
        let positions = (0..121_u16)
            .map(|at| [f32::from(at % 11), 0.0, f32::from(at / 11)])
            .collect();
        let squares = (0..100_u32).map(|at| at / 10 * 11 + at % 10);
        let corners = squares
            .flat_map(|first| [first, first + 1, first + 12, first + 11])
            .collect();
        (positions, corners, (0..=100).map(|face| 4 * face).collect())
    }

    #[test]
    fn rays_and_points_find_the_floor_and_nothing_beside_it() {
        let (positions, corners, starts) = floor();
        let floor = Triangles::of(
            &positions,
            Faces {
                corners: &corners,
                starts: &starts,
            },
            0.7,
        )
        .unwrap();
        let down = [0.0, -1.0, 0.0];
        assert!(floor.crosses([3.3, 2.0, 4.4], down, 2.5));
        assert!(!floor.crosses([3.3, 2.0, 4.4], down, 1.5));
        assert!(!floor.crosses([13.3, 2.0, 4.4], down, 9.0));
        assert!(!floor.crosses([3.3, 2.0, 4.4], [0.0, 1.0, 0.0], 9.0));
        assert!(
            floor.is_within([10.0, 0.0, 12.0], 2.1) && !floor.is_within([10.0, 0.0, 12.0], 1.9)
        );
    }

    #[test]
    fn no_triangles_no_places() {
        let starts = [0, 3];
        let flat = [[f32::NAN; 3], [0.0; 3], [1.0; 3]];
        assert!(
            Triangles::of(
                &flat,
                Faces {
                    corners: &[0, 1, 2],
                    starts: &starts
                },
                1.0
            )
            .is_none()
        );
        assert!(Triangles::of(&[], Faces::default(), 1.0).is_none());
        assert!(
            Triangles::of(
                &[[1.0; 3]; 3],
                Faces {
                    corners: &[0, 1, 2],
                    starts: &starts
                },
                0.0
            )
            .is_none()
        );
    }
}
