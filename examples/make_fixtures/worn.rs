//! The text of an asset that is worn (`docs/loaders/makehuman2/clothes.md#keywords`).

use std::fmt::Write;

use crate::icon;
use crate::mesh::{Mesh, Point, round};
use crate::patch::Patch;
use crate::tree::Tree;

pub(crate) struct Worn {
    pub(crate) name: &'static str,
    pub(crate) folder: &'static str,
    pub(crate) uuid: &'static str,
    pub(crate) tags: &'static [&'static str],
    pub(crate) z_depth: u8,
    /// What it names, relative to its own folder.
    pub(crate) material: Option<&'static str>,
    pub(crate) has_weights: bool,
    pub(crate) patch: Patch,
    pub(crate) fit: Fit,
    /// Two base vertices and an axis, of which the distance is measured.
    pub(crate) scales: Vec<(char, [usize; 2])>,
    /// Runs of base vertices that it hides.
    pub(crate) hidden: Vec<[usize; 2]>,
}

/// How the vertices are tied to the base.
pub(crate) enum Fit {
    /// Each lies on a base vertex.
    Exact,
    /// Each lies this far from a base vertex, away from a point.
    Away(Point, f64),
}

/// The shares of a vertex and its two neighbours.
const SHARES: [f64; 3] = [0.7, 0.2, 0.1];

impl Worn {
    pub(crate) fn add(&self, tree: &mut Tree, mesh: &Mesh) {
        let Self { name, folder, .. } = self;
        let path = format!("data/{folder}/figure/{name}/{name}");
        let ending = if *folder == "proxy" { "proxy" } else { "mhclo" };
        let points: Vec<Point> = self
            .patch
            .vertices
            .iter()
            .map(|&vertex| self.place(mesh, vertex))
            .collect();
        tree.add(format!("{path}.{ending}"), self.text(mesh, &points));
        tree.add(format!("{path}.obj"), self.patch.obj(name, &points));
        tree.add(
            format!("{path}.thumb"),
            icon::png(&format!("{folder} {name}"), 32, 32),
        );
    }

    fn place(&self, mesh: &Mesh, vertex: usize) -> Point {
        let point = mesh.vertices[vertex];
        let Fit::Away(from, distance) = self.fit else {
            return point;
        };
        let away = [0, 1, 2].map(|axis| point[axis] - from[axis]);
        let length = away.iter().map(|value| value * value).sum::<f64>().sqrt();
        [0, 1, 2].map(|axis| round(point[axis] + distance * away[axis] / length, 4))
    }

    fn text(&self, mesh: &Mesh, points: &[Point]) -> String {
        let Self {
            name,
            uuid,
            z_depth,
            ..
        } = self;
        let mut text = String::from(
            "# Asset of the mhlint example repository, released as CC0\n# author: mhlint\n# license: CC0\n",
        );
        let _ = write!(
            text,
            "basemesh figure\n\nname {name}\nuuid {uuid}\ndescription The {name} of the figure\n"
        );
        for tag in self.tags {
            let _ = writeln!(text, "tag {tag}");
        }
        let _ = writeln!(text, "obj_file {name}.obj");
        if let Some(material) = self.material {
            let _ = writeln!(text, "material {material}");
        }
        if self.has_weights {
            let _ = writeln!(text, "vertexboneweights_file {name}.mhw");
        }
        for (axis, [a, b]) in &self.scales {
            let at = ['x', 'y', 'z']
                .iter()
                .position(|letter| letter == axis)
                .expect("invariant: one of three");
            let distance = (mesh.vertices[*a][at] - mesh.vertices[*b][at]).abs();
            let _ = writeln!(text, "{axis}_scale {a} {b} {distance:.4}");
        }
        let _ = write!(text, "max_pole 8\nz_depth {z_depth}\n\nverts 0\n");
        for (number, point) in points.iter().enumerate() {
            let _ = writeln!(text, "{}", self.row(mesh, number, point));
        }
        if !self.hidden.is_empty() {
            text.push_str("\ndelete_verts\n");
        }
        for [first, last] in &self.hidden {
            let _ = if first == last {
                writeln!(text, "{first}")
            } else {
                writeln!(text, "{first} - {last}")
            };
        }
        text
    }

    fn row(&self, mesh: &Mesh, number: usize, point: &Point) -> String {
        let vertex = self.patch.vertices[number];
        if matches!(self.fit, Fit::Exact) {
            return vertex.to_string();
        }
        let [a, b] = self.patch.neighbours(number);
        let corners = [vertex, a, b].map(|corner| mesh.vertices[corner]);
        let middle = |axis: usize| {
            SHARES
                .iter()
                .zip(&corners)
                .map(|(share, corner)| share * corner[axis])
                .sum::<f64>()
        };
        let offset = [0, 1, 2].map(|axis| round(point[axis] - middle(axis), 4));
        let numbers: Vec<String> = SHARES
            .iter()
            .chain(&offset)
            .map(|number| format!("{number:.4}"))
            .collect();
        format!("{vertex} {a} {b} {}", numbers.join(" "))
    }
}
