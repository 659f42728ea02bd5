//! Joint positions: the mean of a few vertices of the current mesh.
//!
//! Source: `docs/loaders/makehuman2/skeletons.md#rest-pose`.

use super::super::error::EvalError;
use super::super::mesh::point;
use super::super::vector::{Point, add, narrow, scale, widen};

/// Mean of the listed vertices; a vertex listed twice counts twice. Rounded to storage precision,
/// as the application keeps it.
///
/// Negative indices (counted from the end by the application) are the caller's to resolve.
///
/// # Errors
/// No vertices, or one outside the mesh.
pub fn joint_position(positions: &[Point], vertices: &[u32]) -> Result<Point, EvalError> {
    if vertices.is_empty() {
        return Err(EvalError::EmptyJoint);
    }
    let mut sum = [0.0; 3];
    for vertex in vertices {
        sum = add(sum, widen(point(positions, *vertex)?));
    }
    Ok(narrow(scale(sum, 1.0 / vertices.len() as f64)))
}

/// Positions of many joints, in their order.
///
/// # Errors
/// As `joint_position`, for the first joint concerned.
pub fn joint_positions<'a>(
    positions: &[Point],
    joints: impl IntoIterator<Item = &'a [u32]>,
) -> Result<Vec<Point>, EvalError> {
    joints
        .into_iter()
        .map(|vertices| joint_position(positions, vertices))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [Point; 3] = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 6.0, 0.0]];

    #[test]
    fn joint_is_the_mean_of_its_vertices() {
        assert_eq!(joint_position(&MESH, &[0, 1, 2]), Ok([1.0, 2.0, 0.0]));
    }

    #[test]
    fn vertex_listed_twice_counts_twice() {
        assert_eq!(joint_position(&MESH, &[0, 1, 1]), Ok([2.0, 0.0, 0.0]));
    }

    #[test]
    fn empty_joint_and_unknown_vertex_are_errors() {
        assert_eq!(joint_position(&MESH, &[]), Err(EvalError::EmptyJoint));
        assert_eq!(
            joint_positions(&MESH, [&[0][..], &[0, 3][..]]),
            Err(EvalError::vertex(3, 3))
        );
    }

    #[test]
    fn joint_follows_the_mesh() {
        let moved = MESH.map(|p| [p[0] + 1.0, p[1], p[2] - 2.0]);
        assert_eq!(joint_position(&moved, &[0, 1, 2]), Ok([2.0, 2.0, -2.0]));
    }
}
