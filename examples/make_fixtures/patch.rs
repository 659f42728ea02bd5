//! Pieces of surface that assets are made of: base vertices, and faces that number the vertices of
//! the piece.

use std::fmt::Write;

use crate::figure::Body;
use crate::mesh::{Mesh, Point};
use crate::voxel::GridPoint;

pub(crate) struct Patch {
    /// The base vertex behind each vertex of the piece.
    pub(crate) vertices: Vec<usize>,
    pub(crate) faces: Vec<[usize; 4]>,
}

impl Patch {
    /// The faces of which all corners are wanted, with their corners.
    pub(crate) fn of(mesh: &Mesh, is_wanted: impl Fn(usize) -> bool) -> Self {
        let faces: Vec<_> = mesh
            .faces
            .iter()
            .filter(|face| face.iter().all(|&corner| is_wanted(corner)))
            .collect();
        let mut vertices: Vec<usize> = faces.iter().flat_map(|face| face.iter().copied()).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let number = |corner: usize| {
            vertices
                .binary_search(&corner)
                .expect("invariant: a corner of a wanted face")
        };
        let faces = faces.into_iter().map(|face| face.map(number)).collect();
        Self { vertices, faces }
    }

    /// Part of the skin, chosen by grid points.
    pub(crate) fn of_skin(body: &Body, is_wanted: impl Fn(GridPoint) -> bool) -> Self {
        Self::of(&body.mesh, |vertex| {
            body.grid.get(vertex).is_some_and(|&point| is_wanted(point))
        })
    }

    /// Boxes in line: each ring of four grid points is tied to the next, and both ends are closed.
    pub(crate) fn of_boxes(body: &Body, lines: &[Vec<[GridPoint; 4]>]) -> Self {
        let mut patch = Self {
            vertices: Vec::new(),
            faces: Vec::new(),
        };
        for rings in lines {
            let first = patch.vertices.len();
            patch
                .vertices
                .extend(rings.iter().flatten().map(|&point| vertex_at(body, point)));
            let corner = |ring: usize, at: usize| first + 4 * ring + at % 4;
            for ring in 1..rings.len() {
                let side = |at| {
                    [
                        corner(ring - 1, at),
                        corner(ring - 1, at + 1),
                        corner(ring, at + 1),
                        corner(ring, at),
                    ]
                };
                patch.faces.extend([0, 1, 2, 3].map(side));
            }
            patch.faces.push([3, 2, 1, 0].map(|at| corner(0, at)));
            patch
                .faces
                .push([0, 1, 2, 3].map(|at| corner(rings.len() - 1, at)));
        }
        patch
    }

    /// The base vertices next to one, along the first face that has it.
    pub(crate) fn neighbours(&self, vertex: usize) -> [usize; 2] {
        let is_corner = |face: &&[usize; 4]| face.contains(&vertex);
        let face = self
            .faces
            .iter()
            .find(is_corner)
            .expect("invariant: every vertex has a face");
        let at = face
            .iter()
            .position(|&corner| corner == vertex)
            .expect("invariant: found above");
        [face[(at + 1) % 4], face[(at + 3) % 4]].map(|corner| self.vertices[corner])
    }

    pub(crate) fn obj(&self, name: &str, points: &[Point]) -> String {
        let mut text =
            format!("# Asset of the mhlint example repository, released as CC0\no {name}\n");
        for [x, y, z] in points {
            let _ = writeln!(text, "v {x:.4} {y:.4} {z:.4}");
        }
        for [x, y, z] in points {
            let _ = writeln!(text, "vt {:.4} {:.4}", 0.5 + (x + 0.2 * z) / 11.0, y / 11.0);
        }
        let _ = writeln!(text, "g {name}");
        for face in &self.faces {
            let corners = face.map(|corner| format!("{0}/{0}", corner + 1));
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
        text
    }
}

pub(crate) fn vertex_at(body: &Body, point: GridPoint) -> usize {
    body.grid
        .iter()
        .position(|&other| other == point)
        .expect("invariant: a point of the skin")
}
