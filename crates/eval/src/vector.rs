//! Three-vectors and the few matrix operations that skeletons need.
//!
//! Storage is `f32`, arithmetic is `f64` but in the innermost loops. Nothing here guards against
//! zero lengths or singular matrices: the result is NaN or infinite, as in the applications.

use std::ops::{Add, Mul, Sub};

/// A position or displacement as stored, in mesh units.
pub type Point = [f32; 3];
/// A three-vector for arithmetic.
pub type Vec3 = [f64; 3];
/// Rows of a 3x3 matrix.
pub type Mat3 = [[f64; 3]; 3];
/// Rows of a 4x4 matrix whose last row is (0, 0, 0, 1).
pub type Mat4 = [[f64; 4]; 4];

/// The 4x4 identity.
pub const IDENTITY: Mat4 = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

/// A stored point for arithmetic.
pub fn widen(p: Point) -> Vec3 {
    p.map(f64::from)
}

/// A number as the applications store it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the one place where results are rounded to float32 storage"
)]
pub fn round_to_f32(value: f64) -> f32 {
    value as f32
}

/// A vector as the applications store it.
pub fn narrow(v: Vec3) -> Point {
    v.map(round_to_f32)
}

/// `a + b`.
pub fn add<T: Copy + Add<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a - b`.
pub fn sub<T: Copy + Sub<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `v * factor`.
pub fn scale(v: Vec3, factor: f64) -> Vec3 {
    v.map(|x| x * factor)
}

/// Dot product.
pub fn dot<T: Copy + Add<Output = T> + Mul<Output = T>>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Cross product `a x b`.
pub fn cross<T: Copy + Sub<Output = T> + Mul<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Euclidean length.
pub fn length(v: Vec3) -> f64 {
    dot(v, v).sqrt()
}

/// Distance of two stored points.
pub fn distance(a: Point, b: Point) -> f64 {
    length(sub(widen(a), widen(b)))
}

/// `v` with length 1; NaN for the zero vector.
pub fn unit(v: Vec3) -> Vec3 {
    let len = length(v);
    v.map(|x| x / len)
}

/// `a * b`.
pub fn multiply(a: &Mat4, b: &Mat4) -> Mat4 {
    let cell = |i: usize, j: usize| {
        a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j]
    };
    std::array::from_fn(|i| std::array::from_fn(|j| cell(i, j)))
}

/// `m * p` for a point.
pub fn transform(m: &Mat4, p: Vec3) -> Vec3 {
    add(rotate(m, p), translation(m))
}

/// The 3x3 part of `m` times `v`.
pub fn rotate(m: &Mat4, v: Vec3) -> Vec3 {
    std::array::from_fn(|i| m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2])
}

/// Column 3: where the matrix moves the origin.
pub fn translation(m: &Mat4) -> Vec3 {
    [m[0][3], m[1][3], m[2][3]]
}

/// The matrix with the columns `x`, `y`, `z` and the translation `t`.
pub fn from_columns(x: Vec3, y: Vec3, z: Vec3, t: Vec3) -> Mat4 {
    let row = |i: usize| [x[i], y[i], z[i], t[i]];
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}

/// Inverse of a matrix whose last row is (0, 0, 0, 1); NaN or infinite if it has none.
pub fn inverse(m: &Mat4) -> Mat4 {
    let row = |i: usize| [m[i][0], m[i][1], m[i][2]];
    // The columns of the inverse of a 3x3 matrix are the cross products of its rows, divided by the
    // determinant.
    let (a, b, c) = (
        cross(row(1), row(2)),
        cross(row(2), row(0)),
        cross(row(0), row(1)),
    );
    let det = dot(row(0), a);
    let linear = from_columns(
        a.map(|x| x / det),
        b.map(|x| x / det),
        c.map(|x| x / det),
        [0.0; 3],
    );
    let moved = scale(rotate(&linear, translation(m)), -1.0);
    let with = |i: usize| [linear[i][0], linear[i][1], linear[i][2], moved[i]];
    [with(0), with(1), with(2), [0.0, 0.0, 0.0, 1.0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes_the_matrix() {
        let m = [
            [0.0, -2.0, 0.5, 3.0],
            [1.0, 0.0, 0.0, -1.0],
            [0.0, 0.3, 1.0, 2.0],
            [0.0, 0.0, 0.0, 1.0],
        ];
        let product = multiply(&inverse(&m), &m);
        for (row, expected) in product.iter().zip(IDENTITY) {
            for (x, e) in row.iter().zip(expected) {
                assert!((x - e).abs() < 1e-12, "{product:?}");
            }
        }
    }

    #[test]
    fn cross_is_right_handed() {
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn zero_vector_has_no_direction() {
        assert!(unit([0.0; 3]).iter().all(|x| x.is_nan()));
    }

    #[test]
    fn singular_matrix_has_no_finite_inverse() {
        let singular = [[0.0; 4], [0.0; 4], [0.0; 4], [0.0, 0.0, 0.0, 1.0]];
        assert!(inverse(&singular).iter().flatten().any(|x| !x.is_finite()));
    }

    #[test]
    fn transform_rotates_then_moves() {
        let m = from_columns(
            [0.0, 1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0],
            [10.0, 0.0, 0.0],
        );
        assert_eq!(transform(&m, [1.0, 0.0, 0.0]), [10.0, 1.0, 0.0]);
    }
}
