//! Shape keys as Blender mixes them, and what MPFB makes of coordinates.
//!
//! Source: MPFB, shape keys (`docs/loaders/mpfb/common.md#units`,
//! `docs/loaders/mpfb/targets.md#the-mix`). All is rounded where Blender rounds: bones of fingers
//! are shorter than two hundredths of a unit, and the last digit of their ends turns their axes by
//! a hundred thousandth.

use crate::vector::{Point, add, narrow, scale as scaled, widen};

/// One unit of the OBJ is so many metres of the figure, unless it is said otherwise.
pub const USUAL_SCALE: f32 = 0.1;

/// Vertices of the body itself: helpers follow.
const BODY: usize = 13380;

/// The value of a shape key: Blender limits it.
pub fn key_value(value: f64) -> f64 {
    // NaN stays.
    if value.is_nan() {
        value
    } else {
        value.clamp(0.0, 1.0)
    }
}

/// A point of a file as Blender has it once it is turned and scaled: z up, in units of the mesh.
///
/// Blender scales an object by `1 + (scale - 1)`, in 32 bit, and turns it by the greatest 32 bit
/// angle below a right one: figures of `reference/mpfb_bones.json` and `mpfb_pose.json` that are at
/// the last digit.
pub fn in_blender(point: Point, scale: f32) -> Point {
    let [x, y, z] = point;
    let scale = 1.0 + (scale - 1.0);
    let tilt = TILT * scale;
    [x * scale, y * tilt + z * -scale, y * scale + z * tilt]
}

/// Cosine of the angle that Blender turns a mesh by.
const TILT: f32 = 7.549_79e-8;

/// A mesh with shape keys, in Blender: points of the file, for each key its rows and its value, in
/// the order of the keys. Rows of vertices that the mesh does not have are passed over.
pub fn mixed<'k>(
    points: &[Point],
    keys: impl IntoIterator<Item = (&'k [(u32, Point)], f32)>,
    scale: f32,
) -> Vec<Point> {
    let basis: Vec<Point> = points
        .iter()
        .map(|point| in_blender(*point, scale))
        .collect();
    let mut mix = basis.clone();
    for (rows, value) in keys {
        for (vertex, [x, y, z]) in rows {
            let at = *vertex as usize;
            let (Some(basis), Some(place)) = (basis.get(at), mix.get_mut(at)) else {
                continue;
            };
            let moved = scaled(widen([*x, -*z, *y]), f64::from(scale));
            let key = narrow(add(widen(*basis), moved));
            for axis in 0..3 {
                place[axis] += value * (key[axis] - basis[axis]);
            }
        }
    }
    mix
}

/// The lowest z of the body, in Blender; none of a mesh without vertices.
pub fn lowest_point(positions: &[Point]) -> Option<f32> {
    positions
        .iter()
        .take(BODY)
        .map(|point| point[2])
        .reduce(f32::min)
}

/// Lifts a mesh by as much as its lowest point is away from the ground, also one that hovers above
/// it.
pub fn feet_on_ground(positions: &mut [Point]) {
    let lift = lowest_point(positions).unwrap_or(0.0).abs();
    positions.iter_mut().for_each(|point| point[2] += lift);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_keys_are_limited() {
        assert_eq!(
            [-0.5, 0.25, 3.0, f64::INFINITY].map(key_value),
            [0.0, 0.25, 1.0, 1.0]
        );
        assert!(key_value(f64::NAN).is_nan());
    }

    #[test]
    fn up_becomes_z() {
        let turned = in_blender([1.0, 2.0, 3.0], 0.5);
        let wanted = [0.5, -1.5, 1.0];
        assert!(
            turned
                .iter()
                .zip(wanted)
                .all(|(own, wanted)| (own - wanted).abs() < 3e-7),
            "{turned:?}"
        );
    }

    #[test]
    fn keys_are_added_by_their_values() {
        let rows = [(0, [1.0, 2.0, 3.0]), (7, [1.0; 3])];
        let mesh = mixed(&[[0.0; 3]], [(&rows[..], 0.5), (&rows[..1], 0.25)], 0.1);
        let wanted = [0.075, -0.225, 0.15];
        assert!(
            mesh[0]
                .iter()
                .zip(wanted)
                .all(|(own, wanted)| (own - wanted).abs() < 1e-7),
            "{mesh:?}"
        );
    }

    #[test]
    fn helpers_do_not_stand_on_the_ground() {
        let mut mesh = vec![[0.0, 0.0, -2.0]; BODY];
        mesh.push([0.0, 0.0, -5.0]);
        feet_on_ground(&mut mesh);
        assert_eq!(
            (mesh[0][2], mesh[BODY][2], lowest_point(&mesh)),
            (0.0, -3.0, Some(0.0))
        );
        // It only ever lifts.
        let mut hovering = [[0.0, 0.0, 1.0]];
        feet_on_ground(&mut hovering);
        assert_eq!(hovering, [[0.0, 0.0, 2.0]]);
        feet_on_ground(&mut []);
    }
}
