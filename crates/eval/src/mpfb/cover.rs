//! What the ranges of a setting leave uncovered on a slider from 0 to 1, and where they overlap.
//!
//! Gets ranges that are open at both ends, returns stretches. A slider stores its value in 32 bits,
//! so that only such numbers count. Source: MPFB, macro settings
//! (`docs/loaders/mpfb/macros.md#shares-of-a-setting`).

use crate::vector::round_to_f32;

/// A stretch, closed at both ends, that no range covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Its first value; 0 at the beginning of the slider.
    pub from: f64,
    /// Its last value; 1 at the end of the slider.
    pub to: f64,
    /// Number of the range that ends there; none at the beginning of the slider.
    pub before: Option<usize>,
    /// Number of the range that begins there; none at the end of the slider.
    pub after: Option<usize>,
}

/// A stretch, open at both ends, that two ranges cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Numbers of the two ranges, the one that begins first in front.
    pub ranges: [usize; 2],
}

/// Whether a range has values in it that get shares.
pub fn is_live((lowest, highest): (f64, f64)) -> bool {
    // Of a range without an end all shares are NaN.
    lowest < highest && (highest - lowest).is_finite()
}

/// Live ranges by number, those that begin first in front.
fn sorted(ranges: &[(f64, f64)]) -> Vec<(usize, (f64, f64))> {
    let mut sorted: Vec<_> = ranges
        .iter()
        .copied()
        .enumerate()
        .filter(|(_, range)| is_live(*range))
        .collect();
    sorted.sort_by(|one, other| one.1.0.total_cmp(&other.1.0).then(one.0.cmp(&other.0)));
    sorted
}

/// The holes with a slider value in them, in order.
pub fn holes(ranges: &[(f64, f64)]) -> Vec<Hole> {
    let mut holes = Vec::new();
    let (mut reach, mut before) = (f64::NEG_INFINITY, None);
    for (number, (lowest, highest)) in sorted(ranges) {
        if lowest >= reach {
            holes.push(Hole {
                from: reach,
                to: lowest,
                before,
                after: Some(number),
            });
        }
        if highest > reach {
            (reach, before) = (highest, Some(number));
        }
    }
    holes.push(Hole {
        from: reach,
        to: f64::INFINITY,
        before,
        after: None,
    });
    let clipped = holes.into_iter().map(|hole| {
        let (is_first, is_last) = (hole.from <= 0.0, hole.to >= 1.0);
        let (before, after) = (
            if is_first { None } else { hole.before },
            if is_last { None } else { hole.after },
        );
        Hole {
            from: hole.from.max(0.0),
            to: hole.to.min(1.0),
            before,
            after,
        }
    });
    clipped
        .filter(|hole| values_in(hole.from, hole.to) > 0)
        .collect()
}

/// The overlaps with a slider value in them: of each range with what reaches farthest of those that
/// begin before it.
pub fn overlaps(ranges: &[(f64, f64)]) -> Vec<Overlap> {
    let mut overlaps = Vec::new();
    let mut farthest: Option<(usize, f64)> = None;
    for (number, (lowest, highest)) in sorted(ranges) {
        if let Some((other, reach)) = farthest.filter(|(_, reach)| lowest < *reach) {
            let overlap = Overlap {
                from: lowest,
                to: highest.min(reach),
                ranges: [other, number],
            };
            overlaps.extend((values_between(overlap.from, overlap.to) > 0).then_some(overlap));
        }
        if farthest.is_none_or(|(_, reach)| highest > reach) {
            farthest = Some((number, highest));
        }
    }
    overlaps
}

/// How many slider values lie in a closed stretch.
pub fn values_in(from: f64, to: f64) -> u64 {
    let (from, to) = (from.max(0.0), to.min(1.0));
    if from > to || from.is_nan() || to.is_nan() {
        return 0;
    }
    // From 0 to 1 numbers are ordered as their bits are.
    let up = |value: f64| {
        let near = round_to_f32(value);
        if f64::from(near) < value {
            near.to_bits() + 1
        } else {
            near.to_bits()
        }
    };
    let down = |value: f64| {
        let near = round_to_f32(value);
        if f64::from(near) > value {
            near.to_bits().checked_sub(1)
        } else {
            Some(near.to_bits())
        }
    };
    // A zero may have a sign.
    let (first, last) = (up(from.abs()), down(to.abs()));
    last.and_then(|last| (last + 1).checked_sub(first))
        .map_or(0, u64::from)
}

/// The same without the ends.
fn values_between(from: f64, to: f64) -> u64 {
    let inside = |end: f64| {
        if (0.0..=1.0).contains(&end) {
            values_in(end, end)
        } else {
            0
        }
    };
    if from < to {
        values_in(from, to).saturating_sub(inside(from) + inside(to))
    } else {
        0
    }
}

/// A number near the middle of a stretch that no slider value is: ranges that meet there leave no
/// hole.
pub fn unreachable_near(from: f64, to: f64) -> f64 {
    const STEP: f64 = 1e-9;
    let middle = (f64::midpoint(from, to) / STEP).round() * STEP;
    let beside = (0..8).map(|steps| ((middle / STEP).round() - f64::from(steps)) / 1e9);
    beside
        .into_iter()
        .find(|value| values_in(*value, *value) == 0)
        .unwrap_or(middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AGE: [(f64, f64); 3] = [
        (-0.01, 0.187_499_8),
        (0.187_499_9, 0.499_98),
        (0.499_99, 1.01),
    ];

    #[test]
    fn holes_of_the_shipped_settings() {
        let counts = |ranges: &[(f64, f64)]| -> Vec<u64> {
            holes(ranges)
                .iter()
                .map(|hole| values_in(hole.from, hole.to))
                .collect()
        };
        assert_eq!(counts(&AGE), [7, 336]);
        assert_eq!(counts(&[(-0.01, 0.4998), (0.4999, 1.01)]), [3355]);
        assert_eq!(counts(&[(-0.01, 0.4999), (0.5, 1.01)]), [3356]);
        assert_eq!(counts(&[(-0.01, 0.49), (0.51, 1.01)]), [503_317]);
        assert_eq!(
            holes(&AGE)[0],
            Hole {
                from: 0.187_499_8,
                to: 0.187_499_9,
                before: Some(0),
                after: Some(1)
            }
        );
    }

    #[test]
    fn ranges_that_touch_leave_out_one_value_if_a_slider_has_it() {
        assert_eq!(holes(&[(-1.0, 0.5), (0.5, 2.0)]).len(), 1);
        assert_eq!(holes(&[(-1.0, 0.4999), (0.4999, 2.0)]), []);
        assert_eq!(values_in(0.5, 0.5), 1);
    }

    #[test]
    fn the_ends_of_the_slider_are_values() {
        let hole = |from, to, before, after| Hole {
            from,
            to,
            before,
            after,
        };
        assert_eq!(
            holes(&[(0.0, 1.0)]),
            [hole(0.0, 0.0, None, Some(0)), hole(1.0, 1.0, Some(0), None)]
        );
        assert_eq!(holes(&[(-0.1, 1.1)]), []);
        assert_eq!(holes(&[]), [hole(0.0, 1.0, None, None)]);
        assert_eq!(holes(&[(50.0, 101.0)]), [hole(0.0, 1.0, None, None)]);
        assert_eq!(holes(&[(-2.0, -1.0), (-0.5, 2.0), (3.0, 4.0)]), []);
    }

    #[test]
    fn ranges_that_never_match_cover_nothing() {
        let all = [
            (0.5, -0.1),
            (f64::NEG_INFINITY, f64::INFINITY),
            (f64::NAN, 1.0),
            (-0.1, 1.1),
        ];
        assert_eq!(holes(&all), []);
        assert_eq!(holes(&all[..3]).len(), 1);
        assert_eq!(overlaps(&all), []);
    }

    #[test]
    fn a_range_inside_another_one_overlaps_it() {
        let found = overlaps(&[(0.4, 0.6), (-0.1, 0.5), (0.45, 0.47), (0.6, 1.1)]);
        let overlap = |from, to, ranges| Overlap { from, to, ranges };
        assert_eq!(
            found,
            [overlap(0.4, 0.5, [1, 0]), overlap(0.45, 0.47, [0, 2])]
        );
        let between = 0.5 + f64::from(f32::EPSILON) / 4.0;
        assert_eq!(overlaps(&[(-0.1, between), (0.5, 1.1)]), []);
        assert_eq!(overlaps(&[(-0.3, 0.0), (-0.2, 1.1)]), []);
        assert_eq!(overlaps(&[(-0.3, 0.1), (-0.2, 1.1)]).len(), 1);
    }

    #[test]
    fn a_number_that_no_slider_has_closes_a_hole() {
        for (from, to) in [(0.5, 0.5), (0.187_499_8, 0.187_499_9), (0.49, 0.51)] {
            let at = unreachable_near(from, to);
            assert!((at - f64::midpoint(from, to)).abs() < 1e-8, "{at}");
            assert_eq!(holes(&[(-0.1, at), (at, 1.1)]), [], "{at}");
        }
    }
}
