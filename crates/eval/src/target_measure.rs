//! Shape of single targets: symmetry, which parts of the mesh they move, joint cubes that they
//! tear.

use super::side::Side;
use super::symmetry::{MirrorComparison, MirrorDifference};
use super::vector::{Point, length, sub, widen};

/// A row of a target.
type Row = (u32, Point);

/// Measures of one target.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TargetMeasure {
    /// Path below the target folder.
    pub name: String,
    /// Printed path of its file.
    pub path: String,
    /// Difference from its own mirror image.
    pub own_mirror: MirrorDifference,
    /// The vertex of the visible body that differs most from its mirror image, if any does, with
    /// the difference.
    pub worst_of_body: Option<(u32, f64)>,
    /// Whether all that differs from its mirror image belongs to joint cubes.
    pub differs_in_cubes: bool,
    /// Longest displacement.
    pub longest: f64,
    /// Moved vertices that belong to the visible body.
    pub body: usize,
    /// Moved vertices that belong to joint cubes.
    pub joints: usize,
    /// Moved vertices that belong to neither.
    pub helpers: usize,
    /// Joint cubes that are torn, by number, with the largest difference inside a cube.
    pub torn: Vec<(usize, f64)>,
    /// Joint cubes that are moved as a whole.
    pub rigid: usize,
}

impl TargetMeasure {
    /// The vertex that differs most from its mirror image, and by how much: of the visible body if
    /// any of that differs.
    pub fn most_asymmetric(&self) -> Option<(u32, f64)> {
        self.worst_of_body.or(self.own_mirror.worst)
    }
}

/// Parts of a mesh that targets are measured against.
#[derive(Debug)]
pub struct Parts {
    /// Whether a vertex belongs to a visible face.
    pub body: Vec<bool>,
    /// Vertices of each joint cube, sorted.
    pub cubes: Vec<Vec<u32>>,
    /// Cube of each vertex.
    pub cube_of: Vec<Option<u32>>,
}

/// Displacements of one cube may differ by rounding to three decimals.
pub const RIGID_TOLERANCE: f64 = 2e-3;

impl Parts {
    /// Measures one target. `tolerance` (mesh units) is how far displacements may be from mirrored.
    pub fn measure(
        &self,
        rows: &[Row],
        mirror: &mut MirrorComparison<'_>,
        tolerance: f64,
    ) -> TargetMeasure {
        let own_mirror = mirror.difference(rows.iter().copied(), rows.iter().copied(), tolerance);
        let differs_on_body = own_mirror
            .different
            .iter()
            .any(|vertex| self.is_body(*vertex));
        let mut of_body = || {
            mirror
                .difference(self.of_body(rows), self.of_body(rows), tolerance)
                .worst
        };
        let differs_in_cubes = own_mirror
            .different
            .iter()
            .all(|vertex| self.cube(*vertex).is_some());
        let worst_of_body = if differs_on_body { of_body() } else { None };
        let mut measure = TargetMeasure {
            own_mirror,
            worst_of_body,
            differs_in_cubes,
            ..TargetMeasure::default()
        };
        let mut touched: Vec<(u32, u32, Point)> = Vec::new();
        for (vertex, delta) in rows
            .iter()
            .filter(|(_, delta)| delta.iter().any(|part| *part != 0.0))
        {
            measure.longest = measure.longest.max(length(widen(*delta)));
            let at = *vertex as usize;
            if self.body.get(at).is_some_and(|body| *body) {
                measure.body += 1;
            } else if let Some(cube) = self.cube(*vertex) {
                measure.joints += 1;
                touched.push((cube, *vertex, *delta));
            } else {
                measure.helpers += 1;
            }
        }
        touched.sort_unstable_by_key(|(cube, vertex, _)| (*cube, *vertex));
        for group in touched.chunk_by(|a, b| a.0 == b.0) {
            match self.tear(group) {
                Some(torn) => measure.torn.push(torn),
                None => measure.rigid += 1,
            }
        }
        measure
    }

    /// Compares a left target with its right partner: all vertices, and those of the visible body
    /// alone.
    pub fn pair(
        &self,
        left: &[Row],
        right: &[Row],
        mirror: &mut MirrorComparison<'_>,
        tolerance: f64,
    ) -> (MirrorDifference, MirrorDifference) {
        let whole = mirror.difference(left.iter().copied(), right.iter().copied(), tolerance);
        let body = mirror.difference(self.of_body(left), self.of_body(right), tolerance);
        (whole, body)
    }

    fn of_body<'r>(&'r self, rows: &'r [Row]) -> impl Iterator<Item = Row> + Clone + 'r {
        rows.iter()
            .filter(|(vertex, _)| self.is_body(*vertex))
            .copied()
    }

    fn is_body(&self, vertex: u32) -> bool {
        self.body.get(vertex as usize).is_some_and(|body| *body)
    }

    fn cube(&self, vertex: u32) -> Option<u32> {
        self.cube_of.get(vertex as usize).copied().flatten()
    }

    /// The cube and its largest inner difference, unless all its vertices move alike.
    fn tear(&self, group: &[(u32, u32, Point)]) -> Option<(usize, f64)> {
        let (cube, _, first) = *group.first()?;
        let whole = self.cubes.get(cube as usize).map_or(0, Vec::len);
        let apart = group
            .iter()
            .map(|(_, _, delta)| length(widen(sub(*delta, first))));
        let mut difference = apart.fold(0.0, f64::max);
        if group.len() < whole {
            difference = group
                .iter()
                .map(|(_, _, delta)| length(widen(*delta)))
                .fold(difference, f64::max);
        }
        (difference > RIGID_TOLERANCE).then_some((cube as usize, difference))
    }
}

/// Share of the displacement of a target, by length, from which on it is for one side of the body.
const ONE_SIDED: f64 = 0.9;

/// The side of a mesh on which nearly all of a target lies, if it is one.
pub fn side_of(rows: &[Row], positions: &[Point]) -> Option<Side> {
    let (mut left, mut all) = (0.0, 0.0);
    for (vertex, delta) in rows {
        let moved = length(widen(*delta));
        all += moved;
        match positions.get(*vertex as usize) {
            Some([x, ..]) if *x > 0.0 => left += moved,
            _ => {}
        }
    }
    let share = left / all;
    if share >= ONE_SIDED {
        Some(Side::Left)
    } else {
        (share <= 1.0 - ONE_SIDED).then_some(Side::Right)
    }
}

/// Vertices of joint cubes from the groups of a mesh: name of a cube and its vertices.
pub fn cubes_of<'f>(
    faces: impl IntoIterator<Item = (&'f str, &'f [u32])>,
) -> Vec<(String, Vec<u32>)> {
    let mut cubes: std::collections::BTreeMap<&str, Vec<u32>> = std::collections::BTreeMap::new();
    for (group, face) in faces {
        if group.starts_with("joint-") {
            cubes.entry(group).or_default().extend_from_slice(face);
        }
    }
    let sorted = |(name, mut vertices): (&str, Vec<u32>)| {
        vertices.sort_unstable();
        vertices.dedup();
        (name.to_owned(), vertices)
    };
    cubes.into_iter().map(sorted).collect()
}

#[cfg(test)]
mod tests {
    use super::super::symmetry::MirrorMap;
    use super::*;

    const POSITIONS: [Point; 4] = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [2.0, 5.0, 0.0],
        [2.0, 6.0, 0.0],
    ];

    fn measure(rows: &[Row]) -> TargetMeasure {
        let mirror = MirrorMap::new(&POSITIONS, std::iter::empty::<&[u32]>(), 0.01);
        let parts = Parts {
            body: vec![true, true, false, false],
            cubes: vec![vec![2, 3]],
            cube_of: vec![None, None, Some(0), Some(0)],
        };
        parts.measure(rows, &mut MirrorComparison::new(&mirror), 0.001)
    }

    #[test]
    fn a_cube_moved_in_part_is_torn() {
        let found = measure(&[(0, [0.0, 1.0, 0.0]), (2, [0.0, 0.5, 0.0])]);
        assert_eq!(
            (found.body, found.joints, found.torn.as_slice()),
            (1, 1, [(0, 0.5)].as_slice())
        );
        assert!(!found.differs_in_cubes);
    }

    #[test]
    fn a_target_lies_on_the_side_of_its_longest_displacements() {
        let of = |rows: &[Row]| side_of(rows, &POSITIONS);
        assert_eq!(
            of(&[(0, [0.0, 1.0, 0.0]), (1, [0.0, 0.1, 0.0])]),
            Some(Side::Left)
        );
        assert_eq!(of(&[(0, [0.0, 1.0, 0.0]), (1, [0.0, 0.2, 0.0])]), None);
        assert_eq!(of(&[(1, [0.0, 1.0, 0.0])]), Some(Side::Right));
        assert_eq!(of(&[]), None);
    }

    #[test]
    fn a_cube_moved_as_a_whole_is_rigid() {
        let found = measure(&[(2, [0.0, 0.5, 0.0]), (3, [0.0, 0.501, 0.0])]);
        assert_eq!((found.rigid, found.torn.len()), (1, 0));
    }

    #[test]
    fn one_sided_displacement_differs_from_its_mirror_image() {
        assert_eq!(
            measure(&[(0, [0.0, 1.0, 0.0])]).own_mirror.different.len(),
            2
        );
        assert_eq!(
            measure(&[(0, [0.5, 1.0, 0.0]), (1, [-0.5, 1.0, 0.0])])
                .own_mirror
                .different
                .len(),
            0
        );
    }

    #[test]
    fn the_body_goes_before_what_is_not_shown() {
        let positions = [
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [2.0, 5.0, 0.0],
            [-2.0, 5.0, 0.0],
        ];
        let mirror = MirrorMap::new(&positions, std::iter::empty::<&[u32]>(), 0.01);
        let parts = Parts {
            body: vec![true, true, false, false],
            cubes: Vec::new(),
            cube_of: vec![None; 4],
        };
        let most = |rows: &[Row]| {
            parts
                .measure(rows, &mut MirrorComparison::new(&mirror), 0.001)
                .most_asymmetric()
                .map(|(vertex, _)| vertex)
        };
        let helper = (2, [9.0, 0.0, 0.0]);
        assert_eq!(most(&[helper, (0, [0.0, 1.0, 0.0])]), Some(0));
        assert_eq!(
            most(&[helper, (0, [0.5, 1.0, 0.0]), (1, [-0.5, 1.0, 0.0])]),
            Some(2)
        );
    }
}
