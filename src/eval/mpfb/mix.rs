//! Shape keys as Blender mixes them, and what MPFB makes of coordinates.
//!
//! Source: MPFB, shape keys (formats/mpfb.md §0, §5).

use crate::eval::vector::Point;

/// Vertices of the body itself: helpers follow.
const BODY: usize = 13380;

/// The value of a shape key: Blender limits it.
pub fn key_value(value: f64) -> f64 {
    // NaN stays.
    if value.is_nan() { value } else { value.clamp(0.0, 1.0) }
}

/// A point of a file as Blender has it: z up, in units of the mesh.
pub fn in_blender(point: Point, scale: f32) -> Point {
    [scale * point[0], scale * -point[2], scale * point[1]]
}

/// The lowest z of the body, in Blender; none of a mesh without vertices.
pub fn lowest_point(positions: &[Point]) -> Option<f32> {
    positions.iter().take(BODY).map(|point| point[2]).reduce(f32::min)
}

/// Lifts a mesh by as much as its lowest point is away from the ground, also one that hovers above it.
pub fn feet_on_ground(positions: &mut [Point]) {
    let lift = lowest_point(positions).unwrap_or(0.0).abs();
    positions.iter_mut().for_each(|point| point[2] += lift);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_keys_are_limited() {
        assert_eq!([-0.5, 0.25, 3.0, f64::INFINITY].map(key_value), [0.0, 0.25, 1.0, 1.0]);
        assert!(key_value(f64::NAN).is_nan());
    }

    #[test]
    fn up_becomes_z() {
        assert_eq!(in_blender([1.0, 2.0, 3.0], 0.5), [0.5, -1.5, 1.0]);
    }

    #[test]
    fn helpers_do_not_stand_on_the_ground() {
        let mut mesh = vec![[0.0, 0.0, -2.0]; BODY];
        mesh.push([0.0, 0.0, -5.0]);
        feet_on_ground(&mut mesh);
        assert_eq!((mesh[0][2], mesh[BODY][2], lowest_point(&mesh)), (0.0, -3.0, Some(0.0)));
        // It only ever lifts.
        let mut hovering = [[0.0, 0.0, 1.0]];
        feet_on_ground(&mut hovering);
        assert_eq!(hovering, [[0.0, 0.0, 2.0]]);
        feet_on_ground(&mut []);
    }
}
