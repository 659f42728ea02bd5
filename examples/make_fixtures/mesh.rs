//! A base mesh of quads in named groups, and its OBJ text.
//!
//! Every group owns a contiguous range of vertices and faces and is opened once. Texture
//! coordinates are projected per main direction of a face, so that the seams run where the
//! direction changes.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

/// Coordinates in mesh units (1 unit = 1 dm): x to the left side of the character, y up, z to the
/// front.
pub(crate) type Point = [f64; 3];

pub(crate) struct Group {
    pub(crate) name: String,
    pub(crate) vertices: Range<usize>,
    pub(crate) faces: Range<usize>,
    /// Centre and half edge length of a joint cube; morphs move such a group rigidly.
    pub(crate) cube: Option<(Point, f64)>,
}

#[derive(Default)]
pub(crate) struct Mesh {
    pub(crate) vertices: Vec<Point>,
    pub(crate) faces: Vec<[usize; 4]>,
    pub(crate) groups: Vec<Group>,
}

/// Corners of a cube and its outward quads.
const CUBE: [Point; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];
const CUBE_QUADS: [[usize; 4]; 6] = [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 4, 7, 3],
    [1, 2, 6, 5],
    [0, 1, 5, 4],
    [3, 7, 6, 2],
];

impl Mesh {
    /// Adds a group; `faces` number its own vertices from 0.
    pub(crate) fn add_group(
        &mut self,
        name: &str,
        vertices: &[Point],
        faces: &[[usize; 4]],
    ) -> &mut Group {
        let (first, first_face) = (self.vertices.len(), self.faces.len());
        self.vertices.extend(
            vertices
                .iter()
                .map(|point| point.map(|value| round(value, 4))),
        );
        self.faces
            .extend(faces.iter().map(|face| face.map(|corner| first + corner)));
        self.groups.push(Group {
            name: name.to_owned(),
            vertices: first..self.vertices.len(),
            faces: first_face..self.faces.len(),
            cube: None,
        });
        self.groups.last_mut().expect("invariant: just pushed")
    }

    /// Adds the group `joint-<name>` with the eight corners of a cube.
    pub(crate) fn add_joint(&mut self, name: &str, centre: Point, half: f64) {
        // A cube on the right side lists the mirror images of the left one's corners, so its faces
        // turn round.
        let side = if centre[0] < 0.0 { -1.0 } else { 1.0 };
        let corners = CUBE.map(|c| {
            [
                centre[0] + side * half * c[0],
                centre[1] + half * c[1],
                centre[2] + half * c[2],
            ]
        });
        let mut quads = CUBE_QUADS;
        if side < 0.0 {
            for quad in &mut quads {
                quad.reverse();
            }
        }
        self.add_group(&format!("joint-{name}"), &corners, &quads)
            .cube = Some((centre, half));
    }

    pub(crate) fn obj(&self, object: &str) -> String {
        let mut text =
            format!("# Base mesh of the mhlint example repository, released as CC0\no {object}\n");
        for &[x, y, z] in &self.vertices {
            let _ = writeln!(text, "v {x:.4} {y:.4} {z:.4}");
        }
        let mut uvs = BTreeMap::new();
        let mut body = String::new();
        let mut lines = String::new();
        for group in &self.groups {
            let _ = writeln!(body, "g {}", group.name);
            for face in &self.faces[group.faces.clone()] {
                body.push('f');
                for (&corner, uv) in face.iter().zip(self.project(*face)) {
                    let next = uvs.len() + 1;
                    let number = *uvs.entry(uv.clone()).or_insert_with(|| {
                        let _ = writeln!(lines, "vt {uv}");
                        next
                    });
                    let _ = write!(body, " {}/{number}", corner + 1);
                }
                body.push('\n');
            }
        }
        text + &lines + &body
    }

    /// Texture coordinates of a face: one of eight tiles by direction (±x twice, for each half of
    /// the body).
    fn project(&self, face: [usize; 4]) -> [String; 4] {
        let corners = face.map(|corner| self.vertices[corner]);
        let normal = cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
        let axis = (0..3).fold(0, |best, axis| {
            if normal[axis].abs() > normal[best].abs() {
                axis
            } else {
                best
            }
        });
        let right = corners.iter().map(|corner| corner[0]).sum::<f64>() < 0.0;
        let row = u8::from(normal[axis] < 0.0);
        let column = if axis == 0 {
            u8::from(right)
        } else {
            u8::try_from(axis).expect("invariant: 1 or 2") + 1
        };
        let (across, up) = [(2, 1), (0, 2), (0, 1)][axis];
        corners.map(|corner| {
            let [u, v] = [corner[across], corner[up] - if up == 1 { 5.0 } else { 0.0 }]
                .map(|value| 0.5 + value / 11.0);
            format!(
                "{:.4} {:.4}",
                0.25 * (f64::from(column) + u),
                0.5 * (f64::from(row) + v)
            )
        })
    }
}

/// Rounds to decimals; zero is never negative.
pub(crate) fn round(value: f64, decimals: i32) -> f64 {
    let unit = 10f64.powi(decimals);
    (value * unit).round() / unit + 0.0
}

pub(crate) fn mirrored([x, y, z]: Point) -> Point {
    [0.0 - x, y, z]
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
