//! Displacement fields that the targets of both bases are made of.
//!
//! All are functions of a point with x ≥ 0 and an amount, smooth and with a small gradient, so that
//! any sum of them folds no face. Centres of scaling lie beside the joints on purpose: a joint
//! inside a moved region moves as well.

use crate::mesh::Point;

/// 0 below `from`, 1 above `to`, a smooth step between.
pub(crate) fn ramp(value: f64, from: f64, to: f64) -> f64 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// 1 between the two inner values, 0 outside the outer ones.
pub(crate) fn hill(value: f64, [low, inner_low, inner_high, high]: [f64; 4]) -> f64 {
    ramp(value, low, inner_low) * (1.0 - ramp(value, inner_high, high))
}

pub(crate) fn scaled([x, y, z]: Point, factor: f64) -> Point {
    [x * factor, y * factor, z * factor]
}

pub(crate) fn sum(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Height of the figure's arm axis, which slopes down from the shoulder.
pub(crate) fn arm_axis(x: f64) -> f64 {
    7.6 - 0.22 * (x - 1.3)
}

/// 1 on the figure's arms, 0 on the trunk, the legs and the skirt.
fn arm(x: f64, y: f64) -> f64 {
    ramp(x, 1.2, 1.8) * ramp(y, 5.6, 6.4)
}

/// Away from the axis of every limb: all limbs grow thicker.
pub(crate) fn bulk([x, y, z]: Point, amount: f64) -> Point {
    let leg = 1.0 - ramp(y, 4.3, 5.2);
    let outwards = leg * (x - 0.5) * ramp(x, 0.0, 0.3) + (1.0 - leg) * x.min(1.2);
    scaled(
        [outwards, arm(x, y) * (y - arm_axis(x) + 0.1), z + 0.2],
        amount,
    )
}

pub(crate) fn size([x, y, z]: Point, amount: f64) -> Point {
    scaled([0.5 * x, y, 0.5 * z], amount)
}

pub(crate) fn shoulders([x, y, _]: Point, amount: f64) -> Point {
    [amount * ramp(x, 0.3, 1.3) * ramp(y, 5.9, 7.2), 0.0, 0.0]
}

pub(crate) fn stoop([_, y, _]: Point, amount: f64) -> Point {
    let above = (y - 5.0).max(0.0) / 5.0;
    [0.0, 0.0, amount * above * above]
}

/// Begins below the neck joint, so that this moves a little with the head.
fn head(y: f64) -> f64 {
    ramp(y, 7.85, 8.6)
}

pub(crate) fn head_size([x, y, z]: Point, amount: f64) -> Point {
    scaled([x, y - 7.8, z], amount * head(y))
}

pub(crate) fn head_side([x, y, _]: Point, amount: f64) -> Point {
    scaled([x, 0.0, 0.3], amount * head(y))
}

pub(crate) fn head_oval([x, y, z]: Point, amount: f64) -> Point {
    scaled([-x, y - 7.8, -0.5 * z], amount * head(y))
}

pub(crate) fn chest_depth([x, y, z]: Point, amount: f64) -> Point {
    let chest = hill(y, [6.3, 6.8, 7.3, 7.9]) * (1.0 - ramp(x, 0.9, 1.2));
    [0.0, 0.0, amount * chest * (z + 0.5)]
}

pub(crate) fn belly([_, y, z]: Point, amount: f64) -> Point {
    [
        0.0,
        0.0,
        amount * hill(y, [5.3, 5.9, 6.1, 6.65]) * ramp(z, -0.5, 0.5),
    ]
}

pub(crate) fn torso_height([_, y, _]: Point, amount: f64) -> Point {
    [0.0, amount * ramp(y, 5.3, 7.2), 0.0]
}

pub(crate) fn upper_arm([x, y, z]: Point, amount: f64) -> Point {
    let region = hill(x, [1.3, 1.7, 2.4, 2.9]) * arm(x.max(1.8), y);
    scaled([0.0, y - arm_axis(x) + 0.1, z + 0.3], amount * region)
}

pub(crate) fn lower_arm([x, y, z]: Point, amount: f64) -> Point {
    let region = hill(x, [2.5, 3.0, 3.5, 4.0]);
    scaled([0.0, y - arm_axis(x) + 0.1, z + 0.3], amount * region)
}

pub(crate) fn upper_leg([x, y, z]: Point, amount: f64) -> Point {
    let region = hill(y, [2.4, 3.2, 4.2, 4.75]) * ramp(x, 0.0, 0.25);
    scaled([x - 0.5, 0.0, z + 0.35], amount * region)
}

pub(crate) fn lower_leg([x, y, z]: Point, amount: f64) -> Point {
    scaled(
        [x - 0.5, 0.0, z + 0.35],
        amount * hill(y, [0.6, 1.2, 2.4, 2.9]),
    )
}

pub(crate) fn foot([_, y, z]: Point, amount: f64) -> Point {
    [
        0.0,
        0.0,
        amount * ramp(z, 0.2, 0.8) * (1.0 - ramp(y, 0.6, 1.2)),
    ]
}

fn waist(y: f64) -> f64 {
    hill(y, [5.3, 5.9, 6.0, 6.55])
}

pub(crate) fn waist_girth([x, y, z]: Point, amount: f64) -> Point {
    scaled([x, 0.0, z + 0.25], amount * waist(y))
}

pub(crate) fn waist_depth([_, y, z]: Point, amount: f64) -> Point {
    scaled([0.0, 0.0, z + 0.5], amount * waist(y))
}

pub(crate) fn hips_girth([x, y, z]: Point, amount: f64) -> Point {
    scaled([x, 0.0, z + 0.25], amount * hill(y, [4.5, 5.0, 5.4, 5.85]))
}

pub(crate) fn neck_height([_, y, _]: Point, amount: f64) -> Point {
    [0.0, amount * ramp(y, 7.95, 8.3), 0.0]
}
