//! Lengths along chains of vertices.
//!
//! Source: MakeHuman 2, measure (`docs/loaders/makehuman2/sliders.md#measures`).

use super::error::EvalError;
use super::mesh::point;
use super::vector::{Point, distance};

/// Length of the chain in mesh units: distances of consecutive vertices; the chain is not closed.
/// An empty chain is 0 long.
///
/// # Errors
/// A vertex outside the mesh.
pub fn chain_length(positions: &[Point], chain: &[u32]) -> Result<f64, EvalError> {
    let points = chain
        .iter()
        .map(|v| point(positions, *v))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(points
        .windows(2)
        .map(|pair| distance(pair[0], pair[1]))
        .sum())
}

/// Distance between the first and the last vertex: 0 for a closed or empty chain.
///
/// # Errors
/// A vertex outside the mesh.
pub fn closing_gap(positions: &[Point], chain: &[u32]) -> Result<f64, EvalError> {
    match (chain.first(), chain.last()) {
        (Some(first), Some(last)) => Ok(distance(
            point(positions, *first)?,
            point(positions, *last)?,
        )),
        _ => Ok(0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];

    #[test]
    fn open_chain_is_not_closed() {
        assert_eq!(chain_length(&SQUARE, &[0, 1, 2, 3]), Ok(6.0));
        assert_eq!(closing_gap(&SQUARE, &[0, 1, 2, 3]), Ok(2.0));
    }

    #[test]
    fn closed_chain_has_no_gap() {
        assert_eq!(chain_length(&SQUARE, &[0, 1, 2, 3, 0]), Ok(8.0));
        assert_eq!(closing_gap(&SQUARE, &[0, 1, 2, 3, 0]), Ok(0.0));
    }

    #[test]
    fn empty_chain_is_zero_long() {
        assert_eq!(chain_length(&SQUARE, &[]), Ok(0.0));
        assert_eq!(closing_gap(&SQUARE, &[]), Ok(0.0));
    }

    #[test]
    fn vertex_outside_the_mesh_is_an_error() {
        assert_eq!(chain_length(&SQUARE, &[0, 4]), Err(EvalError::vertex(4, 4)));
    }
}
