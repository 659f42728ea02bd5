//! Small things that the assets of both bases use.

use std::fmt::Write;

/// A `.mhm` model with the given modifiers (`docs/loaders/makehuman2/models.md#modifiers`).
pub(crate) fn start_model(base: &str, modifiers: &[(&str, &str)]) -> String {
    let mut text =
        format!("# Start model of the base {base}, released as CC0\nversion v2.0.1\nname base\n");
    for (pattern, value) in modifiers {
        let _ = writeln!(text, "modifier {pattern} {value}");
    }
    text
}

/// Row-major rotations of pose units, exact in decimals: about z by the angle of the 3-4-5
/// triangle, about x by that of the 7-24-25 triangle.
pub(crate) const TURN: [f64; 9] = [0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0];
pub(crate) const TURN_BACK: [f64; 9] = [0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0];
pub(crate) const NOD: [f64; 9] = [1.0, 0.0, 0.0, 0.0, 0.96, -0.28, 0.0, 0.28, 0.96];
pub(crate) const NOD_BACK: [f64; 9] = [1.0, 0.0, 0.0, 0.0, 0.96, 0.28, 0.0, -0.28, 0.96];
