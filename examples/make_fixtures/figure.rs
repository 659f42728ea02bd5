//! The base mesh `figure`: a humanoid of about ten units in a T pose, with joint cubes and a skirt
//! helper.
//!
//! The body is the outside of a set of grid cells (`voxel`), bent into shape: each ring of grid
//! points around a limb gets a centre and half widths from the tables below. Grid sides run from
//! -12 (right finger tips) to 12, heights from 0 (soles) to 18 (crown), depths from -1 (back) to 3
//! (toes).

use std::collections::BTreeSet;

use crate::fields::arm_axis;
use crate::mesh::{Mesh, Point, mirrored};
use crate::voxel::{self, GridPoint};

pub(crate) struct Body {
    pub(crate) mesh: Mesh,
    /// Grid point of each vertex of group `body`.
    pub(crate) grid: Vec<GridPoint>,
}

/// Joint cubes of the centre and the left side; those on the left get a mirror image.
const JOINTS: [(&str, Point, f64); 14] = [
    ("pelvis", [0.0, 5.0, -0.02], 0.1),
    ("spine", [0.0, 5.95, -0.05], 0.1),
    ("chest", [0.0, 6.9, -0.05], 0.1),
    ("neck", [0.0, 8.0, -0.04], 0.05),
    ("head", [0.0, 8.55, 0.0], 0.1),
    ("head-top", [0.0, 9.85, 0.0], 0.05),
    ("l-shoulder", [1.3, 7.6, -0.02], 0.05),
    ("l-elbow", [2.75, 7.281, -0.18], 0.05),
    ("l-wrist", [4.05, 6.995, 0.08], 0.05),
    ("l-fingers", [4.8, 6.83, 0.15], 0.05),
    ("l-hip", [0.6, 4.8, -0.02], 0.1),
    ("l-knee", [0.57, 2.75, 0.14], 0.05),
    ("l-ankle", [0.57, 0.5, -0.08], 0.05),
    ("l-toe", [0.57, 0.15, 0.9], 0.05),
];

/// Heights 0 to 6: height, centre side, half width, centre depth, half depth.
const LEG: [[f64; 5]; 7] = [
    [0.0, 0.57, 0.28, -0.08, 0.3],
    [0.55, 0.57, 0.22, -0.08, 0.27],
    [1.6, 0.57, 0.3, -0.04, 0.36],
    [2.35, 0.57, 0.29, 0.08, 0.31],
    [2.75, 0.57, 0.31, 0.14, 0.33],
    [3.15, 0.57, 0.33, 0.11, 0.36],
    [4.0, 0.58, 0.4, 0.02, 0.45],
];

/// The front of the foot at depths 2 and 3: depth, half width, height of the instep.
const FOOT: [[f64; 3]; 2] = [[0.62, 0.3, 0.4], [1.05, 0.27, 0.3]];

/// Heights 7 to 13: height, sides of the grid sides 1 to 3, centre depth, half depth.
const TORSO: [[f64; 6]; 7] = [
    [4.75, 0.15, 0.6, 1.05, 0.0, 0.5],
    [5.3, 0.38, 0.78, 1.15, 0.0, 0.58],
    [5.95, 0.32, 0.62, 0.9, -0.02, 0.45],
    [6.6, 0.36, 0.72, 1.02, -0.02, 0.52],
    [7.25, 0.38, 0.78, 1.15, -0.02, 0.55],
    [7.6, 0.38, 0.8, 1.3, -0.03, 0.5],
    [7.95, 0.3, 0.75, 1.1, -0.04, 0.34],
];

/// Sides 4 to 12: side, half height, centre depth, half depth.
const ARM: [[f64; 4]; 9] = [
    [1.6, 0.3, -0.03, 0.32],
    [2.1, 0.27, -0.09, 0.28],
    [2.45, 0.24, -0.14, 0.25],
    [2.75, 0.23, -0.18, 0.24],
    [3.05, 0.22, -0.14, 0.23],
    [3.55, 0.21, -0.03, 0.21],
    [4.05, 0.16, 0.08, 0.17],
    [4.45, 0.15, 0.12, 0.24],
    [4.9, 0.12, 0.16, 0.18],
];

/// Heights 14 to 18: height, half width, centre depth, half depth.
const HEAD: [[f64; 4]; 5] = [
    [8.22, 0.24, -0.02, 0.26],
    [8.55, 0.32, 0.06, 0.4],
    [9.0, 0.42, 0.05, 0.5],
    [9.5, 0.44, 0.02, 0.52],
    [10.0, 0.3, -0.02, 0.36],
];

/// How far the corners of a round limb are pulled in.
const CORNER: f64 = 0.8;

/// Points around the skirt, as shares of its half widths.
const AROUND: [[f64; 2]; 12] = [
    [0.0, 1.0],
    [0.5, 0.87],
    [0.87, 0.5],
    [1.0, 0.0],
    [0.87, -0.5],
    [0.5, -0.87],
    [0.0, -1.0],
    [-0.5, -0.87],
    [-0.87, -0.5],
    [-1.0, 0.0],
    [-0.87, 0.5],
    [-0.5, 0.87],
];

/// The skirt as a closed ring, four lines around: height, half width, half depth.
const SKIRT: [[f64; 3]; 4] = [
    [5.25, 1.32, 0.8],
    [4.2, 1.45, 1.0],
    [4.2, 1.37, 0.92],
    [5.25, 1.25, 0.73],
];

pub(crate) fn build() -> Body {
    let surface = voxel::surface(&cells());
    let mut mesh = Mesh::default();
    let places: Vec<Point> = surface.points.iter().map(|&point| place(point)).collect();
    mesh.add_group("body", &places, &surface.quads);
    for (name, centre, half) in JOINTS {
        mesh.add_joint(name, centre, half);
        if let Some(rest) = name.strip_prefix("l-") {
            mesh.add_joint(&format!("r-{rest}"), mirrored(centre), half);
        }
    }
    let (points, quads) = skirt();
    mesh.add_group("helper-skirt", &points, &quads);
    Body {
        mesh,
        grid: surface.points,
    }
}

impl Body {
    /// The closed line of vertices around the torso at a grid height.
    pub(crate) fn girth(&self, height: i32) -> Vec<usize> {
        let front = (0..=3).map(|i| (i, 1)).chain([(3, 0)]);
        let back = (-3..=3).rev().map(|i| (i, -1)).chain([(-3, 0)]);
        let around = front.chain(back).chain((-3..=0).map(|i| (i, 1)));
        let number = |point| self.grid.iter().position(|&other| other == point);
        around.filter_map(|(i, k)| number((i, height, k))).collect()
    }
}

fn cells() -> BTreeSet<GridPoint> {
    let mut cells = BTreeSet::new();
    voxel::add_mirrored(&mut cells, 1..3, 0..7, -1..1); // legs
    voxel::add_mirrored(&mut cells, 1..3, 0..1, 1..3); // feet
    voxel::add_mirrored(&mut cells, 0..3, 7..13, -1..1); // torso
    voxel::add_mirrored(&mut cells, 3..12, 11..13, -1..1); // arms
    voxel::add_mirrored(&mut cells, 0..1, 13..18, -1..1); // neck and head
    cells
}

fn place((i, j, k): GridPoint) -> Point {
    let (side, depth) = (i.abs(), f64::from(k));
    let point = match j {
        _ if side > 3 => arm(index(side - 4), f64::from(j - 12), depth),
        ..7 if k > 1 => foot(index(k - 2), f64::from(side - 2), j),
        ..7 => leg(index(j), f64::from(side - 2), k),
        7..14 => torso(index(j - 7), side, depth),
        _ => head(index(j - 14), f64::from(side), depth),
    };
    if i < 0 { mirrored(point) } else { point }
}

fn leg(row: usize, across: f64, k: i32) -> Point {
    let [y, x, width, z, thick] = LEG[row];
    let depth = f64::from(k);
    // In the foot, the ring is open to the front.
    let round = if k < 0 || row > 1 {
        corner(across, depth)
    } else {
        1.0
    };
    [x + across * width * round, y, z + depth * thick * round]
}

fn foot(row: usize, across: f64, j: i32) -> Point {
    let [z, width, instep] = FOOT[row];
    let round = if row == 1 { corner(across, 1.0) } else { 1.0 };
    [
        LEG[0][1] + across * width * round,
        f64::from(j) * instep,
        z - (1.0 - round) * 0.4,
    ]
}

fn torso(row: usize, side: i32, depth: f64) -> Point {
    let [y, x1, x2, x3, z, thick] = TORSO[row];
    let at = index(side);
    let (narrow, thin) = if depth.abs() < 0.5 {
        (1.0, 0.0)
    } else {
        ([1.0, 1.0, 0.97, 0.92][at], [1.0, 0.97, 0.87, 0.55][at])
    };
    // The shoulders fall off to the sides and are highest in the middle; the crotch hangs a little.
    let top = if row == 6 {
        [0.03, 0.03, 0.0, -0.08][at] + 0.04 * (1.0 - depth.abs())
    } else {
        0.0
    };
    let crotch = if row == 0 {
        [-0.06, -0.04, 0.0, 0.02][at]
    } else {
        0.0
    };
    [
        [0.0, x1, x2, x3][at] * narrow,
        y + top + crotch,
        z + depth * thin * thick,
    ]
}

fn arm(row: usize, up: f64, depth: f64) -> Point {
    let [x, high, z, thick] = ARM[row];
    let round = corner(up, depth);
    let tip = if row == 8 && up.abs() + depth.abs() < 0.5 {
        0.05
    } else {
        0.0
    };
    [
        x + tip,
        arm_axis(x) + up * high * round,
        z + depth * thick * round,
    ]
}

fn head(row: usize, across: f64, depth: f64) -> Point {
    let [y, width, z, thick] = HEAD[row];
    let round = corner(across, depth);
    let crown = if row == 4 && across.abs() + depth.abs() < 0.5 {
        0.1
    } else {
        0.0
    };
    let nose = if row == 2 && across < 0.5 && depth > 0.5 {
        0.12
    } else {
        0.0
    };
    [
        across * width * round,
        y + crown,
        z + depth * thick * round + nose,
    ]
}

fn skirt() -> (Vec<Point>, Vec<[usize; 4]>) {
    let (count, lines) = (AROUND.len(), SKIRT.len());
    let mut points = Vec::new();
    let mut quads = Vec::new();
    for (line, [y, width, thick]) in SKIRT.into_iter().enumerate() {
        for (at, [x, z]) in AROUND.into_iter().enumerate() {
            points.push([x * width, y, z * thick]);
            let (next, below) = ((at + 1) % count, (line + 1) % lines);
            quads.push([
                line * count + at,
                below * count + at,
                below * count + next,
                line * count + next,
            ]);
        }
    }
    (points, quads)
}

fn corner(across: f64, depth: f64) -> f64 {
    if across.abs() > 0.5 && depth.abs() > 0.5 {
        CORNER
    } else {
        1.0
    }
}

fn index(value: i32) -> usize {
    usize::try_from(value).expect("invariant: the grid has no such point")
}
