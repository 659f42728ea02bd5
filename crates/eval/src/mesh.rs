//! A mesh as a whole: its vertices, box and sum.

use super::error::EvalError;
use super::vector::{Point, Vec3, add, widen};

/// Position of a vertex.
pub(super) fn point(positions: &[Point], vertex: u32) -> Result<Point, EvalError> {
    positions
        .get(vertex as usize)
        .copied()
        .ok_or_else(|| EvalError::vertex(vertex, positions.len()))
}

/// Smallest and largest coordinates; `None` without points. NaN coordinates do not count.
pub fn bounding_box(positions: &[Point]) -> Option<(Point, Point)> {
    let first = *positions.first()?;
    Some(positions.iter().fold((first, first), |(low, high), p| {
        (
            std::array::from_fn(|i| low[i].min(p[i])),
            std::array::from_fn(|i| high[i].max(p[i])),
        )
    }))
}

/// Sum of each coordinate over all points.
pub fn coordinate_sum(positions: &[Point]) -> Vec3 {
    positions
        .iter()
        .fold([0.0; 3], |sum, p| add(sum, widen(*p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];

    #[test]
    fn box_and_sum() {
        assert_eq!(bounding_box(&SQUARE), Some(([0.0; 3], [2.0, 2.0, 0.0])));
        assert_eq!(bounding_box(&[]), None);
        assert_eq!(
            bounding_box(&[[f32::NAN, 0.0, 0.0], [1.0; 3]]),
            Some(([1.0, 0.0, 0.0], [1.0; 3]))
        );
        assert_eq!(coordinate_sum(&SQUARE), [4.0, 4.0, 0.0]);
    }
}
