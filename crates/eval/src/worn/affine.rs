//! The affine map that brings one list of points nearest to another.

use crate::vector::{Mat3, Point, Vec3, add, cross, dot, from_columns, inverse, scale, sub, widen};

/// A map `p -> linear * (p - from) + to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Affine {
    linear: Mat3,
    from: Vec3,
    to: Vec3,
}

/// Parts of the points that are left out in the end, as they may be anywhere.
const OUTLIERS: usize = 10;
/// How often the worst are left out and the map is made anew.
const TURNS: usize = 3;
/// What is added to the spread of flat shapes, a part of the whole: they have no third direction.
const FLAT: f64 = 1e-6;

impl Affine {
    /// The map from `before` to `after`, of which a tenth may be anywhere. `None` for fewer than
    /// four points.
    pub(super) fn between(before: &[Point], after: &[Point]) -> Option<Self> {
        let mut pairs: Vec<(Vec3, Vec3)> = before
            .iter()
            .zip(after)
            .map(|(a, b)| (widen(*a), widen(*b)))
            .collect();
        pairs.retain(|(a, b)| a.iter().chain(b).all(|part| part.is_finite()));
        // Those that are far from the middle on either side are left out first: one of them bends
        // the first map.
        let middles = [middle(&pairs, |pair| pair.0), middle(&pairs, |pair| pair.1)];
        let off =
            |(a, b): &(Vec3, Vec3)| [square(sub(*a, middles[0])), square(sub(*b, middles[1]))];
        let usual = [0, 1].map(|side| {
            median(pairs.iter().map(|pair| off(pair)[side]).collect()).max(f64::MIN_POSITIVE)
        });
        let far = |pair: &(Vec3, Vec3)| off(pair)[0] / usual[0] + off(pair)[1] / usual[1];
        let mut map = Self::of(nearest(&mut pairs, far))?;
        for _ in 1..TURNS {
            map = Self::of(nearest(&mut pairs, |(a, b)| {
                square(sub(map.of_point(*a), *b))
            }))?;
        }
        Some(map)
    }

    fn of(pairs: &[(Vec3, Vec3)]) -> Option<Self> {
        if pairs.len() < 4 {
            return None;
        }
        let share = 1.0 / pairs.len() as f64;
        let mean = |side: fn(&(Vec3, Vec3)) -> Vec3| {
            scale(pairs.iter().map(side).fold([0.0; 3], add), share)
        };
        let (from, to) = (mean(|pair| pair.0), mean(|pair| pair.1));
        let (mut spread, mut mixed) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        for (a, b) in pairs {
            let (a, b) = (sub(*a, from), sub(*b, to));
            for row in 0..3 {
                for column in 0..3 {
                    spread[row][column] += a[row] * a[column];
                    mixed[row][column] += b[row] * a[column];
                }
            }
        }
        let trace = spread[0][0] + spread[1][1] + spread[2][2];
        for axis in 0..3 {
            spread[axis][axis] += trace * FLAT;
        }
        // Symmetric, so its rows are its columns.
        let [x, y, z] = spread;
        let inverse = inverse(&from_columns(x, y, z, [0.0; 3]));
        let column = |at: usize| [inverse[0][at], inverse[1][at], inverse[2][at]];
        let linear = mixed.map(|row| [0, 1, 2].map(|at| dot(row, column(at))));
        linear
            .iter()
            .flatten()
            .all(|part| part.is_finite())
            .then_some(Self { linear, from, to })
    }

    /// Whether it makes mirror images.
    pub(super) fn is_mirror(&self) -> bool {
        let [x, y, z] = self.linear;
        dot(x, cross(y, z)) < 0.0
    }

    /// Where a point goes.
    pub(super) fn of_point(&self, point: Vec3) -> Vec3 {
        add(self.of_direction(sub(point, self.from)), self.to)
    }

    /// What becomes of a difference of points.
    pub(super) fn of_direction(&self, direction: Vec3) -> Vec3 {
        self.linear.map(|row| dot(row, direction))
    }
}

/// All but the tenth for which `far` is largest.
fn nearest(pairs: &mut [(Vec3, Vec3)], far: impl Fn(&(Vec3, Vec3)) -> f64) -> &[(Vec3, Vec3)] {
    let kept = pairs.len() - pairs.len() / OUTLIERS;
    if kept < pairs.len() {
        pairs.select_nth_unstable_by(kept, |one, other| far(one).total_cmp(&far(other)));
    }
    pairs.get(..kept).unwrap_or_default()
}

fn middle(pairs: &[(Vec3, Vec3)], side: fn(&(Vec3, Vec3)) -> Vec3) -> Vec3 {
    [0, 1, 2].map(|axis| median(pairs.iter().map(|pair| side(pair)[axis]).collect()))
}

/// The middle one of numbers; 0 without any.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    let half = numbers.len() / 2;
    if numbers.is_empty() {
        0.0
    } else {
        *numbers.select_nth_unstable_by(half, f64::total_cmp).1
    }
}

/// The square of a length.
pub(super) fn square(vector: Vec3) -> f64 {
    dot(vector, vector)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a screw, all different.
    fn screw(count: u16) -> Vec<Point> {
        (0..count)
            .map(f32::from)
            .map(|at| [at.sin(), at.cos(), at * 0.1])
            .collect()
    }

    #[test]
    fn a_turned_stretched_and_moved_shape_is_found() {
        let before = screw(40);
        let after: Vec<Point> = before
            .iter()
            .map(|p| [2.0 * p[2] + 5.0, -p[0], p[1] * 3.0 - 1.0])
            .collect();
        let map = Affine::between(&before, &after).unwrap();
        for (a, b) in before.iter().zip(&after) {
            assert!(square(sub(map.of_point(widen(*a)), widen(*b))) < 1e-6);
        }
    }

    #[test]
    fn a_few_points_anywhere_do_not_matter() {
        let mut before = screw(40);
        let after = screw(40);
        before[7] = [1e6, 0.0, 0.0];
        before[9] = [f32::NAN; 3];
        let map = Affine::between(&before, &after).unwrap();
        assert!(square(sub(map.of_point(widen(before[0])), widen(after[0]))) < 1e-6);
    }

    #[test]
    fn a_flat_shape_has_a_map_and_too_few_points_have_none() {
        let flat: Vec<Point> = screw(20).iter().map(|p| [p[0], p[1], 0.0]).collect();
        assert!(Affine::between(&flat, &flat).is_some());
        assert_eq!(Affine::between(&flat[..3], &flat[..3]), None);
        assert_eq!(Affine::between(&[[1.0; 3]; 9], &[[1.0; 3]; 9]), None);
    }
}
