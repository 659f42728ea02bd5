//! A displacement field applied to a mesh: the text of a `.target` file.
//!
//! A field is asked for points of the left half only and mirrored to the right, so results are
//! exactly symmetric. A joint cube gets the displacement of its centre for all eight corners.

use std::fmt::Write;

use crate::mesh::{Mesh, Point, mirrored, round};

/// Displacement at a point with x ≥ 0.
pub(crate) type Field<'a> = &'a dyn Fn(Point) -> Point;

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Side {
    Both,
    Left,
    Right,
}

const DECIMALS: i32 = 3;

pub(crate) fn target_text(mesh: &Mesh, base: &str, side: Side, field: Field) -> String {
    let mut text = format!(
        "# Morph target of the mhlint example repository, released as CC0\n# basemesh {base}\n"
    );
    for group in &mesh.groups {
        for number in group.vertices.clone() {
            let place = group
                .cube
                .map_or(mesh.vertices[number], |(centre, _)| centre);
            let delta = displacement(place, side, field);
            if delta.iter().any(|value| value.abs() > 0.0) {
                let [x, y, z] = delta.map(short);
                let _ = writeln!(text, "{number} {x} {y} {z}");
            }
        }
    }
    text
}

fn displacement(place: Point, side: Side, field: Field) -> Point {
    let [x, _, _] = place;
    let left = x > 0.0;
    let right = x < 0.0;
    if (side == Side::Left && !left) || (side == Side::Right && !right) {
        return [0.0; 3];
    }
    let delta =
        field(if right { mirrored(place) } else { place }).map(|value| round(value, DECIMALS));
    match (left, right) {
        (true, _) => delta,
        (_, true) => mirrored(delta),
        _ => [0.0, delta[1], delta[2]],
    }
}

/// As `MakeHuman`'s own targets are written: no zero before the point, whole numbers without one.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text.strip_prefix("-0.") {
        Some(digits) => format!("-.{digits}"),
        None => text
            .strip_prefix("0.")
            .map_or_else(|| text.to_owned(), |digits| format!(".{digits}")),
    }
}
