//! What the figure wears: clothes, hair, eyes, teeth, a topology, skins, their materials and
//! pictures.

use std::fmt::Write as _;

use serde_json::json;

use crate::figure::Body;
use crate::icon;
use crate::json_text;
use crate::patch::{Patch, vertex_at};
use crate::tree::Tree;
use crate::voxel::GridPoint;
use crate::worn::{Fit, Worn};

pub(crate) const KILT: &str = "c2f60d3e-7b1a-4e0e-9d44-1a5be0a7c901";
pub(crate) const SHIRT: &str = "38a1d6f4-50c2-4b7f-8e1d-6c09f2b4d702";
pub(crate) const CURLS: &str = "e94b7a10-3d8c-4f26-a5b3-90d1c7e8f203";
pub(crate) const BEADS: &str = "5d07c8b2-e6f1-49a3-b78c-2f4e61a0d504";
pub(crate) const GRIN: &str = "917ee3c5-0a4d-46b8-92f7-d3b58c1e6a05";
pub(crate) const BLOCKS: &str = "f6b2901c-8d37-4c5e-a1e9-7405bd2c3f06";

pub(crate) fn add(tree: &mut Tree, body: &Body) {
    let curls = curls(body);
    tree.add(
        "data/hair/figure/curls/curls.mhw",
        weights(body, &curls.patch),
    );
    for worn in [
        kilt(body),
        shirt(body),
        curls,
        beads(body),
        grin(body),
        blocks(body),
    ] {
        worn.add(tree, &body.mesh);
    }
    for material in MATERIALS {
        material.add(tree);
    }
    let litsphere = "data/shaders/litspheres/pearl.png";
    tree.add(litsphere, icon::texture(litsphere, false));
}

/// On the helper, without a displacement.
fn kilt(body: &Body) -> Worn {
    let group = body
        .mesh
        .groups
        .iter()
        .find(|group| group.name == "helper-skirt");
    let range = group
        .expect("invariant: the figure has this helper")
        .vertices
        .clone();
    Worn {
        name: "kilt",
        folder: "clothes",
        uuid: KILT,
        tags: &["kilt", "casual"],
        z_depth: 40,
        material: Some("kilt.mhmat"),
        has_weights: false,
        patch: Patch::of(&body.mesh, |vertex| range.contains(&vertex)),
        fit: Fit::Exact,
        scales: Vec::new(),
        hidden: Vec::new(),
    }
}

/// Around the trunk, a little away from the skin that it hides.
fn shirt(body: &Body) -> Worn {
    let is_covered = |(i, j, _): GridPoint| i.abs() <= 3 && (9..=10).contains(&j);
    let at = |point| vertex_at(body, point);
    Worn {
        name: "shirt",
        folder: "clothes",
        uuid: SHIRT,
        tags: &["shirt", "warm"],
        z_depth: 60,
        material: Some("shirt.mhmat"),
        has_weights: false,
        patch: Patch::of_skin(body, |(i, j, _)| i.abs() <= 3 && (8..=11).contains(&j)),
        fit: Fit::Away([0.0, 6.5, 0.0], 0.06),
        scales: vec![
            ('x', [at((3, 9, 0)), at((-3, 9, 0))]),
            ('y', [at((0, 11, 1)), at((0, 8, 1))]),
            ('z', [at((0, 10, 1)), at((0, 10, -1))]),
        ],
        hidden: runs((0..body.grid.len()).filter(|&vertex| is_covered(body.grid[vertex]))),
    }
}

/// On the back of the head and its crown.
fn curls(body: &Body) -> Worn {
    Worn {
        name: "curls",
        folder: "hair",
        uuid: CURLS,
        tags: &["short", "curly"],
        z_depth: 80,
        material: Some("curls.mhmat"),
        has_weights: true,
        patch: Patch::of_skin(body, |(_, j, k)| j == 18 || (j >= 15 && k <= 0)),
        fit: Fit::Away([0.0, 9.2, 0.0], 0.05),
        scales: Vec::new(),
        hidden: Vec::new(),
    }
}

/// Two faces over the front of the head.
fn beads(body: &Body) -> Worn {
    Worn {
        name: "beads",
        folder: "eyes",
        uuid: BEADS,
        tags: &["beads"],
        z_depth: 20,
        material: Some("../materials/grey.mhmat"),
        has_weights: false,
        patch: Patch::of_skin(body, |(_, j, k)| (16..=17).contains(&j) && k == 1),
        fit: Fit::Away([0.0, 9.0, 0.0], 0.02),
        scales: Vec::new(),
        hidden: Vec::new(),
    }
}

fn grin(body: &Body) -> Worn {
    Worn {
        name: "grin",
        folder: "teeth",
        uuid: GRIN,
        tags: &["broad"],
        z_depth: 10,
        material: Some("grin.mhmat"),
        has_weights: false,
        patch: Patch::of_skin(body, |(_, j, k)| (15..=16).contains(&j) && k == 1),
        fit: Fit::Exact,
        scales: Vec::new(),
        hidden: Vec::new(),
    }
}

/// A body of boxes that stands for the whole skin.
fn blocks(body: &Body) -> Worn {
    let upright = |sides: [i32; 2], j: i32| {
        [
            (sides[0], j, 1),
            (sides[1], j, 1),
            (sides[1], j, -1),
            (sides[0], j, -1),
        ]
    };
    let along = |i: i32| [(i, 11, 1), (i, 11, -1), (i, 13, -1), (i, 13, 1)];
    let left_arm = [4, 7, 12].map(along).to_vec();
    let right_arm = [-12, -7, -4].map(along).to_vec();
    let leg = |sides| [0, 4, 6].map(|j| upright(sides, j)).to_vec();
    let trunk = [7, 9, 13].map(|j| upright([-3, 3], j)).to_vec();
    let head = [14, 16, 18].map(|j| upright([-1, 1], j)).to_vec();
    Worn {
        name: "blocks",
        folder: "proxy",
        uuid: BLOCKS,
        tags: &["boxes"],
        z_depth: 1,
        material: None,
        has_weights: false,
        patch: Patch::of_boxes(
            body,
            &[left_arm, right_arm, leg([1, 3]), leg([-3, -1]), trunk, head],
        ),
        fit: Fit::Exact,
        scales: Vec::new(),
        hidden: vec![[0, body.grid.len() - 1]],
    }
}

/// The numbers as runs, both ends included.
fn runs(numbers: impl Iterator<Item = usize>) -> Vec<[usize; 2]> {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for number in numbers {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == number => *last = number,
            _ => runs.push([number, number]),
        }
    }
    runs
}

/// Hair hangs on the head; its lowest line follows the neck a little.
fn weights(body: &Body, hair: &Patch) -> String {
    let is_low = |vertex: usize| body.grid[hair.vertices[vertex]].1 == 15;
    let share = |vertex: usize| if is_low(vertex) { 0.75 } else { 1.0 };
    let head: Vec<_> = (0..hair.vertices.len())
        .map(|vertex| json!([vertex, share(vertex)]))
        .collect();
    let neck: Vec<_> = (0..hair.vertices.len())
        .filter(|&vertex| is_low(vertex))
        .map(|at| json!([at, 0.25]))
        .collect();
    json_text::by_hand(&json!({
        "name": "curls weights",
        "version": 110,
        "license": "CC0",
        "description": "Weights of the hair curls.",
        "weights": { "head": head, "neck": neck },
    }))
}

struct Material {
    /// Below `data/`, without an ending.
    path: &'static str,
    lines: &'static str,
    /// Keyword, name beside the material, whether it is transparent.
    textures: &'static [(&'static str, &'static str, bool)],
    has_thumb: bool,
}

const MATERIALS: [Material; 9] = [
    Material {
        path: "clothes/figure/kilt/kilt",
        lines: "diffuseColor 1.0 1.0 1.0\nroughnessFactor 0.8\nshader phong\n",
        textures: &[("diffuseTexture", "kilt.png", false)],
        has_thumb: false,
    },
    Material {
        path: "clothes/figure/shirt/shirt",
        lines: "diffuseColor 1.0 1.0 1.0\nmetallicFactor 0.0\nroughnessFactor 0.7\nshader pbr\n",
        textures: &[
            ("diffuseTexture", "shirt.png", false),
            ("normalmapTexture", "shirt_folds.png", false),
        ],
        has_thumb: false,
    },
    Material {
        path: "clothes/figure/shirt/shirt_green",
        lines: "diffuseColor 0.2 0.6 0.3\nshader toon\n",
        textures: &[],
        has_thumb: true,
    },
    Material {
        path: "hair/figure/curls/curls",
        lines: "diffuseColor 1.0 1.0 1.0\ntransparent True\nalphaToCoverage True\nbackfaceCull False\nshader phong\n",
        textures: &[("diffuseTexture", "curls.png", true)],
        has_thumb: false,
    },
    Material {
        path: "eyes/figure/materials/grey",
        lines: "diffuseColor 1.0 1.0 1.0\nshader litsphere\nshaderParam litsphereTexture pearl.png\nshaderParam AdditiveShading 0.4\n",
        textures: &[("diffuseTexture", "grey_beads.png", false)],
        has_thumb: true,
    },
    Material {
        path: "eyes/figure/materials/amber",
        lines: "diffuseColor 1.0 1.0 1.0\nshader litsphere\nshaderParam litsphereTexture pearl.png\n",
        textures: &[("diffuseTexture", "amber_beads.png", false)],
        has_thumb: true,
    },
    Material {
        path: "teeth/figure/grin/grin",
        lines: "diffuseColor 0.9 0.9 0.85\nspecularColor 0.5 0.5 0.5\nshader phong\n",
        textures: &[],
        has_thumb: false,
    },
    Material {
        path: "skins/figure/clay",
        lines: "diffuseColor 0.7 0.5 0.4\nroughnessFactor 0.9\nshader phong\n",
        textures: &[],
        has_thumb: true,
    },
    Material {
        path: "skins/figure/copper/copper",
        lines: "diffuseColor 1.0 1.0 1.0\nmetallicFactor 0.9\naomapIntensity 0.8\nshader pbr\n",
        textures: &[
            ("diffuseTexture", "copper.png", false),
            ("aomapTexture", "copper_ao.png", false),
        ],
        has_thumb: true,
    },
];

impl Material {
    fn add(&self, tree: &mut Tree) {
        let (folder, name) = self
            .path
            .rsplit_once('/')
            .expect("invariant: paths of the table have folders");
        let mut text = format!(
            "# Material of the mhlint example repository, released as CC0\nname {name}\n{}",
            self.lines
        );
        for (keyword, picture, is_transparent) in self.textures {
            let _ = writeln!(text, "{keyword} {picture}");
            tree.add(
                format!("data/{folder}/{picture}"),
                icon::texture(picture, *is_transparent),
            );
        }
        tree.add(format!("data/{}.mhmat", self.path), text);
        if self.has_thumb {
            tree.add(
                format!("data/{}.thumb", self.path),
                icon::png(self.path, 32, 32),
            );
        }
    }
}
