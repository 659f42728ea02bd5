//! Distance of a point from a triangle.

use crate::vector::{Vec3, add, dot, length, scale, sub};

/// How far a point is from a triangle, by the region of its plane that it is over (Ericson,
/// Real-Time Collision Detection, 5.1.5).
pub(super) fn from_triangle(point: Vec3, [a, b, c]: [Vec3; 3]) -> f64 {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(point, a));
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return length(ap);
    }
    let bp = sub(point, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return length(bp);
    }
    let cp = sub(point, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
    if d6 >= 0.0 && d5 <= d6 {
        return length(cp);
    }
    let on =
        |from: Vec3, along: Vec3, share: f64| length(sub(point, add(from, scale(along, share))));
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return on(a, ab, d1 / (d1 - d3));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return on(a, ac, d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return on(b, sub(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let whole = va + vb + vc;
    length(sub(ap, add(scale(ab, vb / whole), scale(ac, vc / whole))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_region_has_its_nearest_point() {
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        for (point, expected) in [
            ([1.0, 1.0, 3.0], 3.0),
            ([-3.0, -4.0, 0.0], 5.0),
            ([7.0, -4.0, 0.0], 5.0),
            ([-4.0, 7.0, 0.0], 5.0),
            ([2.0, -2.0, 0.0], 2.0),
            ([-2.0, 2.0, 0.0], 2.0),
            ([4.0, 4.0, 0.0], 8.0_f64.sqrt()),
        ] {
            assert!(
                (from_triangle(point, triangle) - expected).abs() < 1e-12,
                "{point:?}"
            );
        }
    }
}
