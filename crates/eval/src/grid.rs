//! Points by place: which vertices lie within a fixed distance of a point.
//!
//! Built in linear time, asked in constant time.

use super::lists::Lists;
use super::steps::step;
use super::vector::{Point, distance};

/// A place with more vertices around it than this is not searched: meshes from strangers may have
/// all vertices in one place.
const CROWD: usize = 256;

/// Vertices sorted into cubes of twice the tolerance, the cubes into hash buckets.
pub(super) struct Grid<'a> {
    positions: &'a [Point],
    tolerance: f64,
    cell: f64,
    buckets: usize,
    vertices: Lists<u32>,
}

type Cell = [i64; 3];

impl<'a> Grid<'a> {
    pub(super) fn new(positions: &'a [Point], tolerance: f32) -> Self {
        let tolerance = f64::from(tolerance).max(f64::MIN_POSITIVE);
        let buckets = positions.len().next_power_of_two().max(2);
        let mut grid = Self {
            positions,
            tolerance,
            cell: tolerance * 2.0,
            buckets,
            vertices: Lists::default(),
        };
        let places: Vec<usize> = positions
            .iter()
            .map(|p| grid.bucket(grid.cell_of(p.map(f64::from))))
            .collect();
        grid.vertices = Lists::new(buckets, places.iter().copied().zip(0..));
        grid
    }

    /// Vertices within the tolerance of `p` and their distances, in ascending order of vertices.
    /// False if the place is so crowded that the search was given up; `found` is then incomplete.
    pub(super) fn near(&self, p: Point, found: &mut Vec<(u32, f64)>) -> bool {
        found.clear();
        let wide = p.map(f64::from);
        let low = self.cell_of(wide.map(|x| x - self.tolerance));
        let high = self.cell_of(wide.map(|x| x + self.tolerance));
        let mut looked_at = 0;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let bucket = self.in_bucket([x, y, z]);
                    looked_at += bucket.len();
                    if looked_at > CROWD {
                        return false;
                    }
                    self.collect(p, [x, y, z], bucket, found);
                }
            }
        }
        found.sort_by_key(|c| c.0);
        true
    }

    /// The vertices of the bucket that a cell is in.
    fn in_bucket(&self, cell: Cell) -> &[u32] {
        self.vertices.of(self.bucket(cell))
    }

    /// Adds what one cell holds of a bucket.
    fn collect(&self, p: Point, cell: Cell, bucket: &[u32], found: &mut Vec<(u32, f64)>) {
        for vertex in bucket {
            step();
            let other = self.positions[*vertex as usize];
            let distance = distance(p, other);
            // Buckets are shared by cells, and a vertex must be found through its own cell only.
            if distance <= self.tolerance && self.cell_of(other.map(f64::from)) == cell {
                found.push((*vertex, distance));
            }
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "saturates; points that far away or NaN have no partner within the tolerance"
    )]
    fn cell_of(&self, p: [f64; 3]) -> Cell {
        // The bound keeps `low..=high` short at both ends of the range.
        p.map(|x| ((x / self.cell).floor() as i64).clamp(-(1 << 52), 1 << 52))
    }

    #[expect(clippy::cast_sign_loss, reason = "a hash: any bits will do")]
    fn bucket(&self, cell: Cell) -> usize {
        let mixed = cell.iter().fold(0_u64, |hash, c| {
            (hash.rotate_left(21) ^ (*c as u64)).wrapping_mul(0x9E37_79B9_7F4A_7C15)
        });
        (mixed >> 32) as usize & (self.buckets - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::steps::steps_of;
    use super::*;

    fn near(positions: &[Point], tolerance: f32, p: Point) -> Vec<u32> {
        let mut found = vec![(99, 0.0)];
        assert!(Grid::new(positions, tolerance).near(p, &mut found));
        found.iter().map(|c| c.0).collect()
    }

    #[test]
    fn finds_exactly_what_a_plain_search_finds() {
        let mut state = 1_u32;
        let mut axis = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) as f32 / 65_536.0 - 0.5
        };
        let mesh: Vec<Point> = (0..2000).map(|_| [axis(), axis(), axis()]).collect();
        for p in mesh.iter().step_by(97) {
            let plain: Vec<u32> = (0..)
                .zip(&mesh)
                .filter(|(_, q)| distance(*p, **q) <= 0.1)
                .map(|(i, _)| i)
                .collect();
            assert_eq!(near(&mesh, 0.1, *p), plain);
            assert!(plain.len() > 1);
        }
    }

    #[test]
    fn crowded_place_is_given_up() {
        let grid = [[1.0; 3]; 1000];
        let grid = Grid::new(&grid, 0.1);
        let steps = steps_of(|| assert!(!grid.near([1.0; 3], &mut Vec::new())));
        assert!(steps <= CROWD as u64, "{steps}");
    }

    #[test]
    fn cells_across_zero_are_neighbours() {
        assert_eq!(
            near(&[[-0.01, 0.0, 0.0], [0.01, 0.0, 0.0]], 0.05, [0.0; 3]),
            [0, 1]
        );
    }

    #[test]
    fn no_points_no_neighbours() {
        assert!(near(&[], 0.1, [0.0; 3]).is_empty());
    }

    #[test]
    fn extreme_places_and_tolerances_end() {
        let mesh = [[f32::MAX; 3], [f32::NAN; 3], [0.0; 3]];
        assert_eq!(near(&mesh, f32::MIN_POSITIVE, [f32::MAX; 3]), [0]);
        assert_eq!(near(&mesh, f32::NAN, [0.0; 3]), [2]);
        assert_eq!(near(&mesh, 0.0, [0.0; 3]), [2]);
    }
}
