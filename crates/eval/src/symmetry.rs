//! Mirror partners of the vertices of a mesh, found from its shape.
//!
//! Gets rest positions and faces; returns for every vertex the one on the other side of a plane x =
//! constant, or that there is none or no telling which. Exact equality is not needed. Where several
//! vertices share a place, the faces decide. `MirrorComparison` compares targets by it.

use super::grid::Grid;
use super::mesh::bounding_box;
use super::steps::step;
use super::vector::{Point, distance};

/// Partner of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirror {
    /// This vertex; itself in the middle plane.
    Partner(u32),
    /// Nothing lies at the mirrored place.
    Unmatched,
    /// Several vertices lie there and their neighbours do not tell which, or the choice is not
    /// mutual.
    Ambiguous,
}

/// Mirror partners of all vertices: partners are always mutual.
#[derive(Clone, Debug, PartialEq)]
pub struct MirrorMap {
    partners: Vec<Mirror>,
}

/// The second nearest vertex must be further away than the nearest by this part of the tolerance,
/// otherwise both share a place.
const SAME_PLACE: f64 = 0.1;
/// Places with more candidates than this are not settled by their neighbours.
const MOST_CANDIDATES: usize = 16;
/// A vertex joined to more others than this, which only meshes from strangers have, is not settled
/// by its neighbours: it would be asked for again with each of them.
const MOST_NEIGHBOURS: usize = 64;

impl MirrorMap {
    /// Finds the partners. `tolerance` in mesh units: how far from the exact mirror image a partner
    /// may be.
    ///
    /// The plane is x = 0, unless that leaves half of the mesh without partner and the middle of
    /// its bounding box does better: not every base stands in the middle.
    pub fn new<'a, F>(positions: &[Point], faces: F, tolerance: f32) -> Self
    where
        F: IntoIterator<Item = &'a [u32]> + Clone,
    {
        let centred = Self::with_plane(positions, faces.clone(), tolerance, 0.0);
        if centred.unresolved().0 * 2 <= positions.len() {
            return centred;
        }
        let middle =
            bounding_box(positions).map_or(0.0, |(low, high)| f32::midpoint(low[0], high[0]));
        let shifted = Self::with_plane(positions, faces, tolerance, middle);
        if shifted.unresolved().0 < centred.unresolved().0 {
            shifted
        } else {
            centred
        }
    }

    /// Finds the partners on the other side of x = `plane`.
    pub fn with_plane<'a>(
        positions: &[Point],
        faces: impl IntoIterator<Item = &'a [u32]>,
        tolerance: f32,
        plane: f32,
    ) -> Self {
        let grid = Grid::new(positions, tolerance);
        let mut partners = Vec::with_capacity(positions.len());
        let mut open = vec![Vec::new(); positions.len()];
        let mut found = Vec::new();
        for (p, open) in positions.iter().zip(&mut open) {
            let searched = grid.near([2.0 * plane - p[0], p[1], p[2]], &mut found);
            let partner = if searched {
                nearest(&found, f64::from(tolerance))
            } else {
                Mirror::Ambiguous
            };
            if searched && partner == Mirror::Ambiguous && found.len() <= MOST_CANDIDATES {
                open.extend(found.iter().map(|c| c.0));
            }
            partners.push(partner);
        }
        let mut map = Self { partners };
        if open.iter().any(|candidates| !candidates.is_empty()) {
            map.settle(open, &Neighbours::new(positions.len(), faces));
        }
        map.keep_mutual();
        map
    }

    /// Partner of a vertex; `Unmatched` outside the mesh.
    pub fn of(&self, vertex: u32) -> Mirror {
        self.partners
            .get(vertex as usize)
            .copied()
            .unwrap_or(Mirror::Unmatched)
    }

    /// The partner of a vertex, if it has one.
    pub(super) fn partner(&self, vertex: u32) -> Option<u32> {
        match self.of(vertex) {
            Mirror::Partner(partner) => Some(partner),
            Mirror::Unmatched | Mirror::Ambiguous => None,
        }
    }

    /// Number of vertices without partner: (unmatched, ambiguous).
    pub fn unresolved(&self) -> (usize, usize) {
        let count = |kind| self.partners.iter().filter(|p| **p == kind).count();
        (count(Mirror::Unmatched), count(Mirror::Ambiguous))
    }

    /// Vertices with several candidates (`open`, by vertex) take the one that is joined to the
    /// partners of most of their neighbours.
    fn settle(&mut self, mut open: Vec<Vec<u32>>, neighbours: &Neighbours) {
        let mut pending: Vec<u32> = (0..)
            .zip(&open)
            .filter(|(_, candidates)| !candidates.is_empty())
            .map(|c| c.0)
            .collect();
        while !pending.is_empty() {
            // Choices of one round rest on the round before, so that the order of vertices does not
            // matter.
            let choice = |v: u32| Some((v, self.best(v, &open[v as usize], neighbours)?));
            let chosen: Vec<(u32, u32)> = pending.iter().filter_map(|v| choice(*v)).collect();
            for (vertex, partner) in &chosen {
                self.partners[*vertex as usize] = Mirror::Partner(*partner);
                open[*vertex as usize].clear();
            }
            pending = chosen
                .iter()
                .flat_map(|(vertex, _)| neighbours.of(*vertex))
                .copied()
                .collect();
            pending.retain(|v| {
                open.get(*v as usize)
                    .is_some_and(|candidates| !candidates.is_empty())
            });
            pending.sort_unstable();
            pending.dedup();
        }
    }

    fn best(&self, vertex: u32, candidates: &[u32], neighbours: &Neighbours) -> Option<u32> {
        if neighbours.of(vertex).len() > MOST_NEIGHBOURS {
            return None;
        }
        let score = |candidate: u32| {
            step();
            let joined = neighbours.of(candidate);
            let mirrored = |n: &&u32| match self.of(**n) {
                Mirror::Partner(m) => joined.binary_search(&m).is_ok(),
                _ => false,
            };
            neighbours.of(vertex).iter().filter(mirrored).count()
        };
        let (mut best, mut most, mut tie) = (None, 0, false);
        for candidate in candidates {
            let score = score(*candidate);
            if score > most {
                (best, most, tie) = (Some(*candidate), score, false);
            } else if score == most {
                tie = true;
            }
        }
        best.filter(|_| !tie)
    }

    fn keep_mutual(&mut self) {
        let mutual = |vertex: u32, partner: &Mirror| match partner {
            Mirror::Partner(other) => self.of(*other) == Mirror::Partner(vertex),
            Mirror::Unmatched | Mirror::Ambiguous => true,
        };
        let lonely: Vec<bool> = (0..)
            .zip(&self.partners)
            .map(|(vertex, partner)| !mutual(vertex, partner))
            .collect();
        for (partner, lonely) in self.partners.iter_mut().zip(lonely) {
            if lonely {
                *partner = Mirror::Ambiguous;
            }
        }
    }
}

fn nearest(found: &[(u32, f64)], tolerance: f64) -> Mirror {
    let Some(best) = found.iter().min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return Mirror::Unmatched;
    };
    let alone = found
        .iter()
        .all(|c| c.0 == best.0 || c.1 > best.1 + SAME_PLACE * tolerance);
    if alone {
        Mirror::Partner(best.0)
    } else {
        Mirror::Ambiguous
    }
}

/// Vertices joined by an edge, per vertex, ascending.
struct Neighbours {
    lists: Vec<Vec<u32>>,
}

impl Neighbours {
    fn new<'a>(count: usize, faces: impl IntoIterator<Item = &'a [u32]>) -> Self {
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); count];
        let mut join = |a: u32, b: u32| {
            if let Some(list) = lists.get_mut(a as usize) {
                list.push(b);
            }
        };
        for face in faces {
            for (a, b) in face.iter().zip(face.iter().cycle().skip(1)) {
                join(*a, *b);
                join(*b, *a);
            }
        }
        for list in &mut lists {
            list.sort_unstable();
            list.dedup();
        }
        Self { lists }
    }

    fn of(&self, vertex: u32) -> &[u32] {
        self.lists
            .get(vertex as usize)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }
}

/// How far a target is from being the mirror image of another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MirrorDifference {
    /// Vertices moved by either target that were compared.
    pub compared: usize,
    /// Vertices moved by either target that have no partner.
    pub without_partner: usize,
    /// Compared vertices whose displacements differ by more than the tolerance.
    pub different: Vec<u32>,
    /// Vertex (of the first target) and largest difference in mesh units.
    pub worst: Option<(u32, f64)>,
}

/// Compares targets with mirror images, one after the other: a target costs its rows, not the size
/// of the mesh.
#[derive(Debug)]
pub struct MirrorComparison<'m> {
    map: &'m MirrorMap,
    one: ByVertex<Point>,
    other: ByVertex<Point>,
    looked_at: ByVertex<()>,
}

impl<'m> MirrorComparison<'m> {
    /// Makes room for the displacements of a mesh.
    pub fn new(map: &'m MirrorMap) -> Self {
        let count = map.partners.len();
        Self {
            map,
            one: ByVertex::new(count),
            other: ByVertex::new(count),
            looked_at: ByVertex::new(count),
        }
    }

    /// Compares `one` with the mirror image of `other` (rows of vertex and displacement); pass the
    /// same target twice to test its own symmetry. Of several rows for a vertex the last counts.
    /// Rows outside the mesh are left out. `tolerance` in mesh units. Of equally different vertices
    /// the first is the worst.
    pub fn difference(
        &mut self,
        one: impl Iterator<Item = (u32, Point)> + Clone,
        other: impl Iterator<Item = (u32, Point)> + Clone,
        tolerance: f64,
    ) -> MirrorDifference {
        self.one.fill(one.clone());
        self.other.fill(other.clone());
        self.looked_at.clear();
        let mut result = MirrorDifference::default();
        one.for_each(|(vertex, _)| self.compare(vertex, tolerance, &mut result));
        for (vertex, _) in other {
            let mirrored = self.map.partner(vertex).unwrap_or(vertex);
            self.compare(mirrored, tolerance, &mut result);
        }
        result.different.sort_unstable();
        result
    }

    /// Compares what `one` does to a vertex with what `other` does to its partner, once.
    fn compare(&mut self, vertex: u32, tolerance: f64, result: &mut MirrorDifference) {
        if !self.looked_at.set(vertex, ()) {
            return;
        }
        let moved = self.one.get(vertex);
        let Some(partner) = self.map.partner(vertex) else {
            result.without_partner += usize::from(moves(moved) || moves(self.other.get(vertex)));
            return;
        };
        let image = self.other.get(partner);
        if !moves(moved) && !moves(image) {
            return;
        }
        result.compared += 1;
        let distance = distance(moved, [-image[0], image[1], image[2]]);
        if distance > tolerance || distance.is_nan() {
            result.different.push(vertex);
        }
        let is_worse =
            |(known, worst): (u32, f64)| distance > worst || (distance >= worst && vertex < known);
        if result.worst.is_none_or(is_worse) {
            result.worst = Some((vertex, distance));
        }
    }
}

fn moves(delta: Point) -> bool {
    delta.iter().any(|d| *d != 0.0)
}

/// Something for some vertices of a mesh. Clearing it costs nothing: what bears an older number is
/// not there.
#[derive(Debug)]
struct ByVertex<T> {
    number: u32,
    entries: Vec<(u32, T)>,
}

impl<T: Copy + Default> ByVertex<T> {
    fn new(count: usize) -> Self {
        Self {
            number: 1,
            entries: vec![(0, T::default()); count],
        }
    }

    fn clear(&mut self) {
        self.number = self.number.checked_add(1).unwrap_or_else(|| {
            self.entries.fill((0, T::default()));
            1
        });
    }

    /// Sets what is at a vertex; whether there was room for it and nothing before.
    fn set(&mut self, vertex: u32, value: T) -> bool {
        let Some(entry) = self.entries.get_mut(vertex as usize) else {
            return false;
        };
        let is_new = entry.0 != self.number;
        *entry = (self.number, value);
        is_new
    }

    fn fill(&mut self, rows: impl Iterator<Item = (u32, T)>) {
        self.clear();
        for (vertex, value) in rows {
            self.set(vertex, value);
        }
    }

    fn get(&self, vertex: u32) -> T {
        let entry = self
            .entries
            .get(vertex as usize)
            .filter(|entry| entry.0 == self.number);
        entry.map(|entry| entry.1).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::steps::steps_of;
    use super::*;

    const NO_FACES: [&[u32]; 0] = [];

    fn partners<'a>(
        positions: &[Point],
        faces: impl IntoIterator<Item = &'a [u32]> + Clone,
    ) -> Vec<Mirror> {
        MirrorMap::new(positions, faces, 1e-3).partners
    }

    #[test]
    fn pairs_and_middle_vertices_are_found() {
        let mesh = [
            [1.0, 2.0, 3.0],
            [0.0, 1.0, 0.0],
            [-1.0005, 2.0, 3.0],
            [4.0, 0.0, 0.0],
        ];
        let expected = [
            Mirror::Partner(2),
            Mirror::Partner(1),
            Mirror::Partner(0),
            Mirror::Unmatched,
        ];
        assert_eq!(partners(&mesh, NO_FACES), expected);
    }

    #[test]
    fn pair_close_to_the_plane_is_not_taken_for_the_middle() {
        let mesh = [[4e-4, 0.0, 0.0], [-4e-4, 0.0, 0.0]];
        assert_eq!(
            partners(&mesh, NO_FACES),
            [Mirror::Partner(1), Mirror::Partner(0)]
        );
    }

    #[test]
    fn shared_place_without_faces_is_ambiguous() {
        let mesh = [
            [1.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
        ];
        assert_eq!(partners(&mesh, NO_FACES), [Mirror::Ambiguous; 4]);
    }

    /// Two strips of one quad on each side that share the places of their upper edge (vertices 2, 3
    /// and 6, 7); mirrored from 8 on.
    fn strips() -> Vec<Point> {
        let side = |x: f32| {
            let strip = |z: f32| {
                [
                    [x, 0.0, z],
                    [2.0 * x, 0.0, z],
                    [2.0 * x, 1.0, 0.0],
                    [x, 1.0, 0.0],
                ]
            };
            [strip(0.5), strip(-0.5)].concat()
        };
        [side(1.0), side(-1.0)].concat()
    }

    #[test]
    fn faces_tell_vertices_of_one_place_apart() {
        let faces: Vec<u32> = (0..16).collect();
        let mesh = strips();
        let found = partners(&mesh, faces.chunks(4));
        let expected: Vec<Mirror> = (0..16).map(|v| Mirror::Partner((v + 8) % 16)).collect();
        assert_eq!(found, expected);
    }

    /// Every vertex shares its place with another one, and all are joined to the first.
    #[test]
    fn a_hub_of_a_mesh_is_not_asked_for_again_and_again() {
        let count = 4000_u32;
        let place = |v: u32| {
            [
                if v.is_multiple_of(2) { 1.0 } else { -1.0 },
                (v / 4) as f32,
                0.0,
            ]
        };
        let mesh: Vec<Point> = (0..count).map(place).collect();
        let faces: Vec<[u32; 3]> = (1..count - 1).map(|v| [0, v, v + 1]).collect();
        let steps = steps_of(|| _ = partners(&mesh, faces.iter().map(<[u32; 3]>::as_slice)));
        assert!(steps < 200 * u64::from(count), "{steps}");
    }

    #[test]
    fn order_of_vertices_does_not_matter() {
        let mesh: Vec<Point> = strips().into_iter().rev().collect();
        let faces: Vec<u32> = (0..16).rev().collect();
        let found = partners(&mesh, faces.chunks(4));
        assert!(found.iter().all(|p| matches!(p, Mirror::Partner(_))));
    }

    #[test]
    fn partners_are_mutual() {
        // Vertex 1 and 2 both lie near the mirror image of 0.
        let mesh = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [-1.0, 0.0009, 0.0]];
        let found = partners(&mesh, NO_FACES);
        assert_eq!(
            found,
            [Mirror::Partner(1), Mirror::Partner(0), Mirror::Ambiguous]
        );
    }

    #[test]
    fn non_finite_and_huge_positions_are_unmatched() {
        let mesh = [
            [f32::NAN; 3],
            [f32::INFINITY, 0.0, 0.0],
            [f32::MAX, 0.0, 0.0],
        ];
        let map = MirrorMap::new(&mesh, NO_FACES, 1e-3);
        assert_eq!(map.unresolved(), (3, 0));
        assert_eq!(map.of(99), Mirror::Unmatched);
    }

    #[test]
    fn mesh_beside_the_plane_is_mirrored_at_its_middle() {
        let mesh = strips()
            .iter()
            .map(|p| [p[0] - 0.25, p[1], p[2]])
            .collect::<Vec<_>>();
        let faces: Vec<u32> = (0..16).collect();
        let map = MirrorMap::new(&mesh, faces.chunks(4), 1e-3);
        assert_eq!(map.unresolved(), (0, 0));
        assert_eq!(
            MirrorMap::with_plane(&mesh, faces.chunks(4), 1e-3, 0.0).unresolved(),
            (16, 0)
        );
    }

    #[test]
    fn zero_tolerance_asks_for_exact_images() {
        let map = MirrorMap::new(&[[1.0, 0.5, 0.0], [-1.0, 0.5, 0.0]], NO_FACES, 0.0);
        assert_eq!(map.unresolved(), (0, 0));
    }

    fn difference(
        map: &MirrorMap,
        one: &[(u32, Point)],
        other: &[(u32, Point)],
        tolerance: f64,
    ) -> MirrorDifference {
        MirrorComparison::new(map).difference(one.iter().copied(), other.iter().copied(), tolerance)
    }

    #[test]
    fn mirrored_targets_do_not_differ() {
        let map = MirrorMap::new(
            &[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [7.0, 0.0, 0.0]],
            NO_FACES,
            1e-3,
        );
        let left = [(0, [0.5, 1.0, 0.0])];
        let same = difference(&map, &left, &[(1, [-0.5, 1.0, 0.0])], 1e-6);
        assert_eq!(
            (same.compared, same.different.len(), same.worst),
            (1, 0, Some((0, 0.0)))
        );
        let alone = difference(&map, &left, &left, 1e-6);
        assert_eq!((alone.compared, alone.different.len()), (2, 2));
        let odd = [(2, [1.0; 3]), (9, [1.0; 3])];
        assert_eq!(difference(&map, &odd, &odd, 1e-6).without_partner, 1);
    }

    #[test]
    fn a_comparison_forgets_the_targets_before() {
        let mesh: Vec<Point> = (0..100_u8)
            .map(|at| {
                [
                    f32::from(at / 2 + 1) * if at % 2 == 0 { 1.0 } else { -1.0 },
                    0.0,
                    0.0,
                ]
            })
            .collect();
        let map = MirrorMap::new(&mesh, NO_FACES, 1e-3);
        let mut comparison = MirrorComparison::new(&map);
        let rows = [
            (8, [9.0; 3]),
            (2, [0.0, 1.0, 0.0]),
            (8, [0.0, 0.5, 0.0]),
            (5, [0.0; 3]),
        ];
        let all = (0..100_u8).map(|vertex| (u32::from(vertex), [f32::from(vertex); 3]));
        for _ in 0..2 {
            let found = comparison.difference(rows.into_iter(), rows.into_iter(), 0.1);
            assert_eq!(
                (found.compared, found.different.len(), found.worst),
                (4, 4, Some((2, 1.0)))
            );
            let found = comparison.difference(all.clone(), rows.into_iter(), 0.1);
            assert_eq!((found.compared, found.different.len()), (99, 99));
        }
    }

    #[test]
    fn numbers_that_ran_out_start_again() {
        let mut entries = ByVertex::new(2);
        entries.number = u32::MAX;
        assert!(entries.set(1, 5.0));
        entries.clear();
        assert_eq!((entries.number, entries.get(1)), (1, 0.0));
    }
}
