//! The base mesh `imp`: a tiny creature without limbs but with two ears, known to the user layer
//! only.
//!
//! Grid sides run from -2 (tip of the right ear) to 2, heights from 0 to 5, depths from -1 to 1.

use std::collections::BTreeSet;

use crate::mesh::{Mesh, Point, mirrored};
use crate::voxel::{self, GridPoint};

pub(crate) struct Imp {
    pub(crate) mesh: Mesh,
    /// Grid point of each vertex of group `body`.
    pub(crate) grid: Vec<GridPoint>,
}

const JOINTS: [(&str, Point); 4] = [
    ("base", [0.0, 0.3, 0.0]),
    ("middle", [0.0, 1.3, 0.05]),
    ("top", [0.0, 2.5, 0.0]),
    ("l-ear", [1.0, 2.35, 0.0]),
];

/// By height: height, half width, half depth.
const RINGS: [[f64; 3]; 6] = [
    [0.0, 0.5, 0.4],
    [0.6, 0.7, 0.6],
    [1.3, 0.6, 0.5],
    [2.0, 0.5, 0.45],
    [2.6, 0.5, 0.45],
    [3.0, 0.35, 0.3],
];

/// Side and thickness of the ear's tip.
const EAR: [f64; 2] = [1.2, 0.5];

pub(crate) fn build() -> Imp {
    let mut cells = BTreeSet::new();
    voxel::add_mirrored(&mut cells, 0..1, 0..5, -1..1); // trunk
    voxel::add_mirrored(&mut cells, 1..2, 3..4, -1..1); // ears
    let surface = voxel::surface(&cells);
    let places: Vec<Point> = surface.points.iter().map(|&point| place(point)).collect();
    let mut mesh = Mesh::default();
    mesh.add_group("body", &places, &surface.quads);
    for (name, centre) in JOINTS {
        mesh.add_joint(name, centre, 0.05);
        if let Some(rest) = name.strip_prefix("l-") {
            mesh.add_joint(&format!("r-{rest}"), mirrored(centre), 0.05);
        }
    }
    Imp {
        mesh,
        grid: surface.points,
    }
}

fn place((i, j, k): GridPoint) -> Point {
    let row = usize::try_from(j).expect("invariant: the grid starts at 0");
    let [height, width, thick] = RINGS[row];
    let (side, depth) = (f64::from(i), f64::from(k));
    let round = if i != 0 && k != 0 { 0.8 } else { 1.0 };
    // Soles and crown bulge out in the middle.
    let bulge = match (i, j, k) {
        (0, 0, 0) => -0.1,
        (0, _, 0) => 0.1,
        _ => 0.0,
    };
    if i.abs() < 2 {
        return [side * width * round, height + bulge, depth * thick * round];
    }
    let [tip, thin] = EAR;
    let point = [tip, 2.3 + (height - 2.3) * thin, depth * thick * thin];
    if i < 0 { mirrored(point) } else { point }
}
