//! Assets fitted to a base mesh.
//!
//! Gets reference lines of an asset as numbers and the base mesh; returns positions.

use super::error::EvalError;
use super::mesh::point;
use super::vector::{Point, Vec3, add, narrow, scale, widen};

/// One vertex of an asset, in terms of the base mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Base vertices, 0-based.
    pub vertices: [u32; 3],
    /// Their weights; used as given, also negative or with a sum other than 1.
    pub weights: [f32; 3],
    /// Displacement in mesh units, multiplied by the scale of each axis.
    pub offset: Point,
}

/// `x_scale` and its kin: two base vertices and the distance they had on that axis when the asset
/// was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleLine {
    /// The two vertices.
    pub vertices: [u32; 2],
    /// Their distance in mesh units.
    pub distance: f32,
}

/// Positions of the asset's vertices on a mesh. The application measures the scales once, when the
/// asset is attached, and keeps them when the mesh changes.
///
/// # Errors
/// A vertex outside the mesh.
pub fn fit(
    positions: &[Point],
    references: &[Reference],
    scales: Option<Vec3>,
) -> Result<Vec<Point>, EvalError> {
    let scales = scales.unwrap_or([1.0; 3]);
    references
        .iter()
        .map(|reference| fitted(positions, reference, scales))
        .collect()
}

fn fitted(positions: &[Point], reference: &Reference, scales: Vec3) -> Result<Point, EvalError> {
    let offset = widen(reference.offset);
    let mut sum = [
        offset[0] * scales[0],
        offset[1] * scales[1],
        offset[2] * scales[2],
    ];
    for (vertex, weight) in reference.vertices.iter().zip(reference.weights) {
        sum = add(
            sum,
            scale(widen(point(positions, *vertex)?), f64::from(weight)),
        );
    }
    Ok(narrow(sum))
}

/// Base vertices that the asset hides. `ranges` holds (first, last), both included; a single index
/// is a range of one, a descending range counts as its first index alone, a negative index counts
/// from the end.
///
/// # Errors
/// An index outside the mesh.
pub fn deleted_vertices(
    ranges: &[(i64, i64)],
    vertex_count: usize,
) -> Result<Vec<bool>, EvalError> {
    let mut deleted = vec![false; vertex_count];
    let place = |index: i64| {
        let outside = EvalError::VertexOutOfRange {
            vertex: index,
            count: vertex_count,
        };
        let from_end = usize::try_from(index.unsigned_abs())
            .ok()
            .and_then(|i| vertex_count.checked_sub(i));
        let found = if index < 0 {
            from_end
        } else {
            usize::try_from(index).ok()
        };
        found.filter(|i| *i < vertex_count).ok_or(outside)
    };
    for (first, last) in ranges {
        let first = place(*first)?;
        let last = place(*last)?.max(first);
        deleted[first..=last].fill(true);
    }
    Ok(deleted)
}

#[cfg(test)]
impl Reference {
    /// A line with one number: the base vertex itself.
    pub(super) fn exact(vertex: u32) -> Self {
        Self {
            vertices: [vertex; 3],
            weights: [1.0, 0.0, 0.0],
            offset: [0.0; 3],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 8.0]];

    #[test]
    fn exact_reference_is_the_vertex_itself() {
        let references: Vec<Reference> = (0..4).map(Reference::exact).collect();
        assert_eq!(fit(&MESH, &references, Some([9.0; 3])).unwrap(), MESH);
    }

    #[test]
    fn offset_is_scaled_by_axis() {
        let reference = Reference {
            vertices: [0, 1, 2],
            weights: [0.5, 0.25, 0.25],
            offset: [1.0, 1.0, 1.0],
        };
        assert_eq!(fit(&MESH, &[reference], None).unwrap(), [[1.5, 2.0, 1.0]]);
        assert_eq!(
            fit(&MESH, &[reference], Some([2.0, 3.0, 4.0])).unwrap(),
            [[2.5, 4.0, 4.0]]
        );
    }

    #[test]
    fn weights_are_not_normalised() {
        let reference = Reference {
            vertices: [1, 2, 3],
            weights: [2.0, -1.0, 0.0],
            offset: [0.0; 3],
        };
        assert_eq!(fit(&MESH, &[reference], None).unwrap(), [[4.0, -4.0, 0.0]]);
    }

    #[test]
    fn reference_outside_the_mesh_is_an_error() {
        assert_eq!(
            fit(&MESH, &[Reference::exact(4)], None),
            Err(EvalError::vertex(4, 4))
        );
    }

    #[test]
    fn delete_ranges_as_the_application_reads_them() {
        let count = |ranges: &[(i64, i64)]| {
            deleted_vertices(ranges, 10).map(|d| d.iter().filter(|d| **d).count())
        };
        assert_eq!(count(&[(2, 4), (4, 5), (9, 9)]), Ok(5));
        assert_eq!(count(&[(7, 3)]), Ok(1));
        assert_eq!(
            deleted_vertices(&[(-1, -1)], 3),
            Ok(vec![false, false, true])
        );
        assert!(
            count(&[(0, 10)]).is_err()
                && count(&[(-11, -11)]).is_err()
                && count(&[(i64::MIN, i64::MAX)]).is_err()
        );
    }
}
