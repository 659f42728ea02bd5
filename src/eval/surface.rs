//! Faces: normals, areas, what a morph does to them; box and sum of a mesh.
//!
//! Gets positions and faces as slices of vertex indices. Faces with a vertex outside the mesh have no area and no
//! normal: other rules report them.

use super::vector::{Point, Vec3, add, cross, dot, length, scale, sub, widen};

/// Area vector of a face (half the sum of the cross products of its fan): direction of the normal, length of the
/// area. Counter-clockwise faces look along it. Zero for fewer than three vertices or a vertex outside the mesh.
pub fn area_vector(positions: &[Point], face: &[u32]) -> Vec3 {
    let corner = |i: usize| face.get(i).and_then(|v| positions.get(*v as usize)).map(|p| widen(*p));
    let mut sum = [0.0; 3];
    for i in 1..face.len().saturating_sub(1) {
        let (Some(a), Some(b), Some(c)) = (corner(0), corner(i), corner(i + 1)) else { return [0.0; 3] };
        sum = add(sum, cross(sub(b, a), sub(c, a)));
    }
    scale(sum, 0.5)
}

/// Area of a face in square units.
pub fn area(positions: &[Point], face: &[u32]) -> f64 {
    length(area_vector(positions, face))
}

/// Sum of all face areas in square units.
pub fn total_area<'a>(positions: &[Point], faces: impl IntoIterator<Item = &'a [u32]>) -> f64 {
    faces.into_iter().map(|face| area(positions, face)).sum()
}

/// What a morph did to the faces of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FaceChange {
    /// Faces whose normal points more than 90 degrees away from where it pointed.
    pub flipped: usize,
    /// First flipped face.
    pub first_flipped: Option<usize>,
    /// Faces whose area fell to the given ratio or below.
    pub collapsed: usize,
    /// Face and ratio of new to old area, the smallest.
    pub smallest: Option<(usize, f64)>,
    /// Face and ratio of new to old area, the largest.
    pub largest: Option<(usize, f64)>,
}

/// Compares the faces of two shapes of one mesh. Faces without area at rest are left out, as there is no ratio.
pub fn face_change<'a>(
    rest: &[Point],
    morphed: &[Point],
    faces: impl IntoIterator<Item = &'a [u32]>,
    collapse_ratio: f64,
) -> FaceChange {
    let mut change = FaceChange::default();
    for (number, face) in faces.into_iter().enumerate() {
        let (before, after) = (area_vector(rest, face), area_vector(morphed, face));
        let old = length(before);
        if old.is_nan() || old == 0.0 {
            continue;
        }
        if dot(before, after) < 0.0 {
            change.flipped += 1;
            change.first_flipped.get_or_insert(number);
        }
        let ratio = length(after) / old;
        change.collapsed += usize::from(ratio <= collapse_ratio);
        if change.smallest.is_none_or(|(_, smallest)| ratio < smallest) {
            change.smallest = Some((number, ratio));
        }
        if change.largest.is_none_or(|(_, largest)| ratio > largest) {
            change.largest = Some((number, ratio));
        }
    }
    change
}

/// Smallest and largest coordinates; `None` without points. NaN coordinates do not count.
pub fn bounding_box(positions: &[Point]) -> Option<(Point, Point)> {
    let first = *positions.first()?;
    Some(positions.iter().fold((first, first), |(low, high), p| {
        (std::array::from_fn(|i| low[i].min(p[i])), std::array::from_fn(|i| high[i].max(p[i])))
    }))
}

/// Sum of each coordinate over all points.
pub fn coordinate_sum(positions: &[Point]) -> Vec3 {
    positions.iter().fold([0.0; 3], |sum, p| add(sum, widen(*p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    const FACES: [&[u32]; 2] = [&[0, 1, 2, 3], &[0, 1, 2]];

    #[test]
    fn area_and_normal_of_quad_and_triangle() {
        assert_eq!(area_vector(&SQUARE, &[0, 1, 2, 3]), [0.0, 0.0, 4.0]);
        assert_eq!(area(&SQUARE, &[0, 1, 2]), 2.0);
        assert_eq!(total_area(&SQUARE, FACES), 6.0);
    }

    #[test]
    fn concave_face_keeps_its_area() {
        let arrow = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 1.0, 0.0], [-2.0, 2.0, 0.0]];
        assert_eq!(area(&arrow, &[0, 1, 2, 3]), 2.0);
    }

    #[test]
    fn broken_faces_have_no_area() {
        assert_eq!(area(&SQUARE, &[0, 1]), 0.0);
        assert_eq!(area(&SQUARE, &[0, 1, 9]), 0.0);
        assert_eq!(area(&SQUARE, &[]), 0.0);
    }

    #[test]
    fn same_shape_has_no_change() {
        let change = face_change(&SQUARE, &SQUARE, FACES, 0.1);
        assert_eq!((change.flipped, change.collapsed), (0, 0));
        assert_eq!(change.smallest, Some((0, 1.0)));
    }

    #[test]
    fn folded_face_is_flipped() {
        let mut folded = SQUARE;
        folded[1] = [0.5, 1.0, 0.0]; // across the diagonal: the triangle turns over, the quad stays concave
        let change = face_change(&SQUARE, &folded, FACES, 0.1);
        assert_eq!((change.flipped, change.first_flipped), (1, Some(1)));
    }

    #[test]
    fn shrunk_faces_are_collapsed() {
        let small = SQUARE.map(|p| p.map(|x| x * 0.1));
        assert_eq!(face_change(&SQUARE, &small, FACES, 0.05).collapsed, 2);
        assert_eq!(face_change(&small, &[[0.0; 3]; 4], FACES, 0.05).largest, Some((0, 0.0)));
        assert_eq!(face_change(&[[0.0; 3]; 4], &small, FACES, 0.05), FaceChange::default());
    }

    #[test]
    fn box_and_sum() {
        assert_eq!(bounding_box(&SQUARE), Some(([0.0; 3], [2.0, 2.0, 0.0])));
        assert_eq!(bounding_box(&[]), None);
        assert_eq!(bounding_box(&[[f32::NAN, 0.0, 0.0], [1.0; 3]]), Some(([1.0, 0.0, 0.0], [1.0; 3])));
        assert_eq!(coordinate_sum(&SQUARE), [4.0, 4.0, 0.0]);
    }
}
