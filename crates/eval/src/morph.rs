//! Targets added to a mesh.
//!
//! Gets positions, rows of (vertex, delta) and a factor; changes the positions. Adds in `f32` in
//! the order given, as the application does. Source: MakeHuman 2, morph evaluation
//! (`docs/loaders/makehuman2/targets.md#rows`, `docs/loaders/makehuman2/targets.md#evaluation`).

use super::error::EvalError;
use super::vector::{Point, round_to_f32};

/// Which target of a detail slider a value uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// `incr`, for values above 0.
    Incr,
    /// `decr`, for values below 0.
    Decr,
}

/// Target and factor for the value of a detail slider (-1..1 nominally, not clamped): `decr` is
/// applied with the absolute value. `None` at 0. A slider that lacks the target of that side does
/// nothing.
pub fn detail_factor(value: f64) -> Option<(Side, f64)> {
    if value == 0.0 {
        return None;
    }
    // NaN is not below 0, so it goes through `incr` into the mesh.
    Some((
        if value < 0.0 { Side::Decr } else { Side::Incr },
        value.abs(),
    ))
}

/// Adds `factor` times the target; `rows` gives vertex (0-based) and displacement (mesh units), in
/// any order. Of several rows for one vertex only the last counts.
///
/// # Errors
/// A vertex outside the mesh; the positions are then unchanged.
pub fn apply<R>(positions: &mut [Point], rows: R, factor: f64) -> Result<(), EvalError>
where
    R: Iterator<Item = (u32, Point)> + Clone,
{
    let count = positions.len();
    if let Some(vertex) = rows
        .clone()
        .map(|row| row.0)
        .max()
        .filter(|v| *v as usize >= count)
    {
        return Err(EvalError::vertex(vertex, count));
    }
    let factor = round_to_f32(factor);
    if rows.clone().is_sorted_by(|a, b| a.0 < b.0) {
        for (vertex, delta) in rows {
            let place = &mut positions[vertex as usize];
            *place = moved(*place, factor, delta);
        }
    } else {
        // All sums are taken from the mesh as it was, then stored in order: so the last row of a
        // vertex wins.
        let sums: Vec<Point> = rows
            .clone()
            .map(|(vertex, delta)| moved(positions[vertex as usize], factor, delta))
            .collect();
        for ((vertex, _), sum) in rows.zip(sums) {
            positions[vertex as usize] = sum;
        }
    }
    Ok(())
}

/// As the application adds: in float32.
pub(super) fn moved(place: Point, factor: f32, delta: Point) -> Point {
    [
        place[0] + factor * delta[0],
        place[1] + factor * delta[1],
        place[2] + factor * delta[2],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [-1.0, 0.5, 0.25]];

    type Rows<'a> = std::iter::Copied<std::slice::Iter<'a, (u32, Point)>>;

    fn rows(rows: &[(u32, Point)]) -> Rows<'_> {
        rows.iter().copied()
    }

    /// The mesh `base` with all targets (rows as for `apply`, and factor) applied in order.
    fn morphed<'r>(
        base: &[Point],
        targets: impl IntoIterator<Item = (Rows<'r>, f64)>,
    ) -> Result<Vec<Point>, EvalError> {
        let mut positions = base.to_vec();
        for (rows, factor) in targets {
            apply(&mut positions, rows, factor)?;
        }
        Ok(positions)
    }

    #[test]
    fn identity_target_gives_the_same_mesh() {
        let zero = [(0, [0.0; 3]), (1, [0.0; 3]), (2, [0.0; 3])];
        assert_eq!(
            morphed(&MESH, [(rows(&zero), 1.0), (rows(&[]), 1.0)]).unwrap(),
            MESH
        );
        assert_eq!(
            morphed(&MESH, [(rows(&[(1, [5.0; 3])]), 0.0)]).unwrap(),
            MESH
        );
    }

    #[test]
    fn last_row_of_a_vertex_wins() {
        let twice = rows(&[(1, [1.0, 0.0, 0.0]), (1, [0.0, 10.0, 0.0])]);
        assert_eq!(morphed(&MESH, [(twice, 1.0)]).unwrap()[1], [1.0, 12.0, 3.0]);
        let apart = rows(&[(2, [1.0; 3]), (0, [2.0; 3]), (2, [0.5; 3])]);
        assert_eq!(
            morphed(&MESH, [(apart, 1.0)]).unwrap(),
            [[2.0; 3], MESH[1], [-0.5, 1.0, 0.75]]
        );
    }

    #[test]
    fn order_of_rows_and_targets_is_irrelevant() {
        let (a, b) = (
            [(0, [0.5; 3]), (2, [0.25; 3])],
            [(2, [0.25; 3]), (0, [0.5; 3])],
        );
        let c = [(1, [1.5; 3]), (2, [-2.0; 3])];
        let one = morphed(&MESH, [(rows(&a), 0.5), (rows(&c), 2.0)]).unwrap();
        assert_eq!(
            one,
            morphed(&MESH, [(rows(&c), 2.0), (rows(&b), 0.5)]).unwrap()
        );
    }

    #[test]
    fn opposite_factors_cancel() {
        let target = [0, 1, 2].map(|vertex| (vertex, [0.5, -1.0, 2.0]));
        assert_eq!(
            morphed(&MESH, [(rows(&target), 1.0), (rows(&target), -1.0)]).unwrap(),
            MESH
        );
    }

    #[test]
    fn vertex_outside_the_mesh_changes_nothing() {
        let mut mesh = MESH;
        let target = rows(&[(0, [1.0; 3]), (3, [1.0; 3])]);
        assert_eq!(apply(&mut mesh, target, 1.0), Err(EvalError::vertex(3, 3)));
        assert_eq!(mesh, MESH);
    }

    #[test]
    fn sliders_use_the_side_of_their_sign() {
        assert_eq!(detail_factor(0.4), Some((Side::Incr, 0.4)));
        assert_eq!(detail_factor(-1.6), Some((Side::Decr, 1.6)));
        assert_eq!(detail_factor(0.0), None);
        assert!(
            detail_factor(f64::NAN)
                .is_some_and(|(side, factor)| side == Side::Incr && factor.is_nan())
        );
    }

    #[test]
    fn non_finite_delta_reaches_the_mesh() {
        let mesh = morphed(&MESH, [(rows(&[(0, [f32::NAN, 0.0, f32::INFINITY])]), 1.0)]).unwrap();
        assert!(mesh[0][0].is_nan() && mesh[0][2].is_infinite());
    }
}
