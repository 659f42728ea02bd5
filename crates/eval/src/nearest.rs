//! The points that are nearest to a place, exactly: half of them after half of them, by place.

use std::collections::BinaryHeap;
use std::ops::Range;

use super::steps::step;
use super::vector::{Point, dot, sub};

/// So many points are looked through one by one.
const FEW: usize = 16;

/// Vertices to find the nearest of.
pub(super) struct Nearest {
    points: Vec<(Point, u32)>,
    /// The top one first.
    blocks: Vec<Block>,
}

/// Some of the points, with the block around them.
struct Block {
    low: Point,
    high: Point,
    /// The smallest number of a vertex.
    first: u32,
    points: Range<usize>,
    /// The numbers of both halves.
    halves: Option<[usize; 2]>,
}

/// The square of a distance as bits, which are in the same order, and the vertex.
type Near = (u32, u32);

impl Nearest {
    /// Of these vertices those that have a position.
    pub(super) fn of(vertices: &[u32], positions: &[Point]) -> Self {
        let point = |vertex: &u32| Some((*positions.get(*vertex as usize)?, *vertex));
        let points: Vec<(Point, u32)> = vertices.iter().filter_map(point).collect();
        let mut nearest = Self {
            blocks: Vec::new(),
            points,
        };
        if !nearest.points.is_empty() {
            nearest.add(0..nearest.points.len());
        }
        nearest
    }

    /// Adds the block around some of the points, with those around its halves; gives its number.
    fn add(&mut self, points: Range<usize>) -> usize {
        let own = self.points.get_mut(points.clone()).unwrap_or_default();
        let (mut low, mut high, mut first) = ([f32::MAX; 3], [f32::MIN; 3], u32::MAX);
        for (point, vertex) in &*own {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
            first = first.min(*vertex);
        }
        let middle = own.len() / 2;
        let is_split = own.len() > FEW;
        if is_split {
            let long = sub(high, low);
            let axis = if long[0] >= long[1] && long[0] >= long[2] {
                0
            } else if long[1] >= long[2] {
                1
            } else {
                2
            };
            own.select_nth_unstable_by(middle, |one, other| {
                let by_place = one.0[axis].total_cmp(&other.0[axis]);
                by_place.then(one.1.cmp(&other.1))
            });
        }
        let number = self.blocks.len();
        let (start, end) = (points.start, points.end);
        self.blocks.push(Block {
            low,
            high,
            first,
            points,
            halves: None,
        });
        if is_split {
            let middle = start + middle;
            let halves = [self.add(start..middle), self.add(middle..end)];
            self.blocks[number].halves = Some(halves);
        }
        number
    }

    /// The vertices that are nearest to a place, as many as are wanted and there are, sorted by
    /// number. Of equally near ones those with smaller numbers are taken.
    pub(super) fn to(&self, place: Point, wanted: usize) -> Vec<u32> {
        let mut found = BinaryHeap::with_capacity(wanted + 1);
        if !self.blocks.is_empty() {
            self.search(0, place, wanted, &mut found);
        }
        let mut vertices: Vec<u32> = found.into_iter().map(|(_, vertex)| vertex).collect();
        vertices.sort_unstable();
        vertices
    }

    fn search(&self, number: usize, place: Point, wanted: usize, found: &mut BinaryHeap<Near>) {
        let own = &self.blocks[number];
        let is_full = found.len() >= wanted;
        if is_full && found.peek().is_none_or(|last| own.at_best(place) > *last) {
            return;
        }
        let Some(mut halves) = own.halves else {
            for (point, vertex) in self.points.get(own.points.clone()).unwrap_or_default() {
                step();
                let way = sub(*point, place);
                found.push((dot(way, way).to_bits(), *vertex));
                if found.len() > wanted {
                    found.pop();
                }
            }
            return;
        };
        halves.sort_by_key(|half| self.blocks[*half].at_best(place));
        halves
            .into_iter()
            .for_each(|half| self.search(half, place, wanted, found));
    }
}

impl Block {
    /// What the nearest of the points could be. Rounding keeps the order of numbers, so that no
    /// point is nearer.
    fn at_best(&self, place: Point) -> Near {
        let way = [0, 1, 2].map(|axis| {
            let (low, high) = (self.low[axis] - place[axis], place[axis] - self.high[axis]);
            low.max(high).max(0.0)
        });
        (dot(way, way).to_bits(), self.first)
    }
}

#[cfg(test)]
mod tests {
    use super::super::steps::steps_of;
    use super::*;

    fn plain(positions: &[Point], place: Point, wanted: usize) -> Vec<u32> {
        let mut all: Vec<Near> = (0..)
            .zip(positions)
            .map(|(vertex, point)| {
                let way = sub(*point, place);
                (dot(way, way).to_bits(), vertex)
            })
            .collect();
        all.sort_unstable();
        let mut nearest: Vec<u32> = all.iter().take(wanted).map(|near| near.1).collect();
        nearest.sort_unstable();
        nearest
    }

    #[test]
    fn finds_exactly_what_a_plain_search_finds() {
        let mut state = 1_u32;
        let mut axis = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 28) as f32 - 8.0
        };
        let positions: Vec<Point> = (0..2000).map(|_| [axis(), axis(), axis() / 3.0]).collect();
        let vertices: Vec<u32> = (0..2000).collect();
        let nearest = Nearest::of(&vertices, &positions);
        for _ in 0..200 {
            let place = [axis() * 1.5, axis() + 0.3, axis()];
            assert_eq!(nearest.to(place, 16), plain(&positions, place, 16));
        }
        assert_eq!(nearest.to([0.0; 3], 3000).len(), 2000);
        assert!(
            Nearest::of(&[7], &positions[..3])
                .to([0.0; 3], 16)
                .is_empty()
        );
    }

    #[test]
    fn few_points_are_looked_at_also_where_all_are_in_one_place() {
        let vertices: Vec<u32> = (0..100_000).collect();
        let line: Vec<Point> = (0..100_000_u32).map(|at| [at as f32, 0.0, 0.0]).collect();
        for positions in [line, vec![[1.0; 3]; 100_000]] {
            let nearest = Nearest::of(&vertices, &positions);
            let steps = steps_of(|| assert_eq!(nearest.to([1.0; 3], 16).len(), 16));
            assert!(steps < 500, "{steps}");
        }
    }
}
