//! The folder `rigs/figure`: default skeleton, its weights and thumbnail.

use crate::figure::Body;
use crate::icon;
use crate::mesh::Group;
use crate::rig::{self, Bone, Influences, Plane, Title};
use crate::tree::Tree;
use crate::voxel::GridPoint;

const FOLDER: &str = "data/rigs/figure";

const TITLE: Title = Title {
    name: "Figure skeleton",
    description: "Default skeleton of the base figure, without fingers and face.",
    tags: &["simple", "no fingers"],
};

const BONES: [Bone; 11] = [
    centre("root", None, "pelvis", "spine"),
    centre("spine", Some("root"), "spine", "chest"),
    centre("chest", Some("spine"), "chest", "neck"),
    centre("neck", Some("chest"), "neck", "head"),
    centre("head", Some("neck"), "head", "head-top"),
    sided("upperarm", "chest", "l-shoulder", "l-elbow", "arm"),
    sided("lowerarm", "upperarm", "l-elbow", "l-wrist", "arm"),
    sided("hand", "lowerarm", "l-wrist", "l-fingers", "arm"),
    sided("upperleg", "root", "l-hip", "l-knee", "leg"),
    sided("lowerleg", "upperleg", "l-knee", "l-ankle", "leg"),
    sided("foot", "lowerleg", "l-ankle", "l-toe", "leg"),
];

const PLANES: [Plane; 3] = [
    Plane {
        name: "trunk",
        joints: ["l-hip", "pelvis", "spine"],
        sided: false,
    },
    Plane {
        name: "arm",
        joints: ["l-shoulder", "l-elbow", "l-wrist"],
        sided: true,
    },
    Plane {
        name: "leg",
        joints: ["l-knee", "l-ankle", "l-toe"],
        sided: true,
    },
];

const fn centre(
    name: &'static str,
    parent: Option<&'static str>,
    head: &'static str,
    tail: &'static str,
) -> Bone {
    Bone {
        name,
        parent,
        head,
        tail,
        plane: "trunk",
        sided: false,
    }
}

const fn sided(
    name: &'static str,
    parent: &'static str,
    head: &'static str,
    tail: &'static str,
    plane: &'static str,
) -> Bone {
    Bone {
        name,
        parent: Some(parent),
        head,
        tail,
        plane,
        sided: true,
    }
}

pub(crate) fn add(tree: &mut Tree, body: &Body) {
    let mesh = &body.mesh;
    let mut influences = Vec::new();
    for group in &mesh.groups {
        for vertex in group.vertices.clone() {
            let x = mesh.vertices[vertex][0];
            let shares = match body.grid.get(vertex) {
                Some(&point) => body_shares(point),
                None => helper_shares(group, mesh.vertices[vertex][1]),
            };
            influences.push(influences_of(group, x, shares));
        }
    }
    tree.add(
        format!("{FOLDER}/default.mhskel"),
        rig::skeleton_text(mesh, &TITLE, &BONES, &PLANES),
    );
    tree.add(
        format!("{FOLDER}/default_weights.mhw"),
        rig::weights_text(&TITLE, &BONES, &influences),
    );
    tree.add(
        format!("{FOLDER}/default.thumb"),
        icon::png("figure skeleton", 64, 64),
    );
}

/// Corners of a joint cube all follow the side of its centre.
fn influences_of(group: &Group, x: f64, shares: Shares) -> Influences {
    rig::influences(
        &BONES,
        group.cube.map_or(x, |(centre, _)| centre[0]),
        shares,
    )
}

type Shares = &'static [(&'static str, f64)];

/// Shares by ring of the grid (see `figure`): half and half at a joint, a quarter on the rings
/// beside it.
fn body_shares((i, j, k): GridPoint) -> Shares {
    match (i.abs(), j) {
        (4, _) => &[("upperarm", 0.75), ("chest", 0.25)],
        (5, _) => &[("upperarm", 1.0)],
        (6, _) => &[("upperarm", 0.75), ("lowerarm", 0.25)],
        (7, _) => &[("upperarm", 0.5), ("lowerarm", 0.5)],
        (8, _) => &[("upperarm", 0.25), ("lowerarm", 0.75)],
        (9, _) => &[("lowerarm", 1.0)],
        (10, _) => &[("lowerarm", 0.5), ("hand", 0.5)],
        (11.., _) => &[("hand", 1.0)],
        (_, 0) => &[("foot", 1.0)],
        (_, 1) if k > 1 => &[("foot", 1.0)],
        (_, 1) => &[("lowerleg", 0.5), ("foot", 0.5)],
        (_, 2) => &[("lowerleg", 1.0)],
        (_, 3) => &[("lowerleg", 0.75), ("upperleg", 0.25)],
        (_, 4) => &[("lowerleg", 0.5), ("upperleg", 0.5)],
        (_, 5) => &[("lowerleg", 0.25), ("upperleg", 0.75)],
        (_, 6) => &[("upperleg", 1.0)],
        (side, _) => torso_shares(side, j),
    }
}

fn torso_shares(side: i32, j: i32) -> Shares {
    match (side, j) {
        (_, 7) => &[("root", 0.5), ("upperleg", 0.5)],
        (3, 8) => &[("root", 0.75), ("upperleg", 0.25)],
        (_, 8) => &[("root", 1.0)],
        (_, 9) => &[("root", 0.5), ("spine", 0.5)],
        (_, 10) => &[("spine", 0.75), ("chest", 0.25)],
        (3, 11) => &[("chest", 0.75), ("upperarm", 0.25)],
        (3, _) => &[("chest", 0.5), ("upperarm", 0.5)],
        (_, 11 | 12) => &[("chest", 1.0)],
        (_, 13) => &[("chest", 0.75), ("neck", 0.25)],
        (_, 14) => &[("neck", 1.0)],
        (_, 15) => &[("neck", 0.5), ("head", 0.5)],
        _ => &[("head", 1.0)],
    }
}

fn helper_shares(group: &Group, y: f64) -> Shares {
    match group.name.split_once('-').map_or("", |(_, rest)| {
        rest.trim_start_matches(['l', 'r']).trim_start_matches('-')
    }) {
        "spine" => &[("spine", 1.0)],
        "chest" => &[("chest", 1.0)],
        "neck" => &[("neck", 1.0)],
        "head" | "head-top" => &[("head", 1.0)],
        "shoulder" => &[("upperarm", 1.0)],
        "elbow" => &[("lowerarm", 1.0)],
        "wrist" | "fingers" => &[("hand", 1.0)],
        "hip" => &[("upperleg", 1.0)],
        "knee" => &[("lowerleg", 1.0)],
        "ankle" | "toe" => &[("foot", 1.0)],
        "skirt" if y < 5.0 => &[("root", 0.5), ("upperleg", 0.5)],
        _ => &[("root", 1.0)],
    }
}
