//! Whether the faces of an asset look inwards.

use super::Wearer;
use crate::faces::{Faces, fan, mean, middle_of, place, vector_of};
use crate::vector::{Point, Vec3, cross, dot, length, scale, sub, widen};

/// Faces of an asset that are compared with the skin under them.
const SAMPLES: usize = 256;
/// Faces look inwards when they look against the skin by this part of their area. The eyes of
/// MakeHuman do, too, as they lie inside the head; but what they enclose is not negative.
const AGAINST: f64 = -0.35;

/// Whether the faces enclose something from its inside, and look against the skin that they lie on.
pub(super) fn is_inside_out(wearer: &Wearer<'_>, faces: Faces<'_>, fitted: &[Point]) -> bool {
    let whole: Vec<&[u32]> = faces.below(fitted.len()).collect();
    let middle = mean(fitted.iter().map(|point| widen(*point)));
    let volume: f64 = whole
        .iter()
        .flat_map(|face| fan(face))
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| sub(place(fitted, vertex), middle));
            dot(a, cross(b, c))
        })
        .sum();
    if !(volume < 0.0) {
        return false;
    }
    let skin = skin(wearer);
    let (mut agreement, mut area) = (0.0, 0.0);
    for face in whole.iter().step_by(whole.len().div_ceil(SAMPLES).max(1)) {
        let own = vector_of(face, fitted);
        let Some(under) = nearest(&skin, middle_of(face, fitted)) else {
            return false;
        };
        agreement += dot(own, under);
        area += length(own);
    }
    agreement < area * AGAINST
}

/// Faces of the skin: middle and direction. Large skins are thinned out.
fn skin(wearer: &Wearer<'_>) -> Vec<(Vec3, Vec3)> {
    let faces: Vec<&[u32]> = wearer.skin.below(wearer.positions.len()).collect();
    let step = faces.len().div_ceil(SAMPLES * 16).max(1);
    let told = faces.iter().step_by(step).map(|face| {
        let vector = vector_of(face, wearer.positions);
        (
            middle_of(face, wearer.positions),
            scale(vector, 1.0 / length(vector)),
        )
    });
    told.filter(|(_, direction)| direction.iter().all(|part| part.is_finite()))
        .collect()
}

fn nearest(skin: &[(Vec3, Vec3)], from: Vec3) -> Option<Vec3> {
    let away = |place: Vec3| {
        let off = sub(place, from);
        dot(off, off)
    };
    let nearest = skin
        .iter()
        .min_by(|one, other| away(one.0).total_cmp(&away(other.0)));
    nearest.map(|(_, direction)| *direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box, its faces looking outwards.
    fn cube(size: f32) -> Vec<Point> {
        let along = |bit: u8, at: u8| if at >> bit & 1 == 1 { size } else { -size };
        (0..8)
            .map(|at| [along(0, at), along(1, at), along(2, at)])
            .collect()
    }

    const OUT: [u32; 24] = [
        0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6,
    ];
    const STARTS: [u32; 7] = [0, 4, 8, 12, 16, 20, 24];

    #[test]
    fn a_box_over_a_box_looks_outwards_until_it_is_turned_over() {
        let (body, coat) = (cube(1.0), cube(1.2));
        let skin = Faces {
            corners: &OUT,
            starts: &STARTS,
        };
        let wearer = Wearer {
            positions: &body,
            skin,
            height: 2.0,
        };
        assert!(!is_inside_out(&wearer, skin, &coat));
        let turned: Vec<u32> = OUT
            .chunks(4)
            .flat_map(|face| face.iter().rev().copied())
            .collect();
        let inside = Faces {
            corners: &turned,
            starts: &STARTS,
        };
        assert!(is_inside_out(&wearer, inside, &coat));
        // An eye in its socket looks against the skin, but outwards.
        assert!(!is_inside_out(
            &Wearer {
                skin: inside,
                ..wearer
            },
            skin,
            &coat
        ));
        assert!(!is_inside_out(&wearer, Faces::default(), &coat));
        assert!(!is_inside_out(
            &Wearer {
                skin: Faces::default(),
                ..wearer
            },
            inside,
            &coat
        ));
    }
}
