//! All files of the base `imp`, a base of the user layer only.
//!
//! Its macros, sliders and targets lie in `contarget/imp`: without a `macro.json` there,
//! `MakeHuman` 2 would look for the targets in the system layer and stop
//! (`docs/loaders/makehuman2/folders.md#overlays`).

use serde_json::{Value, json};

use crate::assets::{self, NOD, NOD_BACK, TURN, TURN_BACK};
use crate::fields::{hill, ramp, scaled};
use crate::icon;
use crate::imp::{self, Imp};
use crate::json_text;
use crate::mesh::{Group, Mesh, Point};
use crate::morph::{Side, target_text};
use crate::rig::{self, Bone, Plane, Title};
use crate::slider::{Detail, Place, add_details, add_icon};
use crate::tree::Tree;

const PLACE: Place = Place {
    base: "imp",
    folder: "user/contarget/imp",
};
const BASE: &str = "user/base/imp";
const RIG: &str = "user/rigs/imp";

const DETAILS: [Detail; 2] = [
    Detail {
        label: "Belly",
        group: "main|body",
        stem: "body/belly-size",
        ends: Some(("decr", "incr")),
        sided: false,
        amount: 0.1,
        field: belly,
    },
    Detail {
        label: "Ear Length",
        group: "main|ears",
        stem: "ears/{side}-ear-trans",
        ends: Some(("in", "out")),
        sided: true,
        amount: 0.12,
        field: ear,
    },
];

const TITLE: Title = Title {
    name: "Imp skeleton",
    description: "Default skeleton of the base imp.",
    tags: &["simple", "creature"],
};

const BONES: [Bone; 3] = [
    Bone {
        name: "root",
        parent: None,
        head: "base",
        tail: "middle",
        plane: "trunk",
        sided: false,
    },
    Bone {
        name: "head",
        parent: Some("root"),
        head: "middle",
        tail: "top",
        plane: "trunk",
        sided: false,
    },
    Bone {
        name: "ear",
        parent: Some("head"),
        head: "top",
        tail: "l-ear",
        plane: "ear",
        sided: true,
    },
];

const PLANES: [Plane; 2] = [
    Plane {
        name: "trunk",
        joints: ["base", "middle", "l-ear"],
        sided: false,
    },
    Plane {
        name: "ear",
        joints: ["middle", "top", "l-ear"],
        sided: true,
    },
];

fn belly([x, y, z]: Point, amount: f64) -> Point {
    scaled([x, 0.0, z + 0.3], amount * hill(y, [-0.5, 0.5, 1.0, 1.9]))
}

fn ear([x, y, _]: Point, amount: f64) -> Point {
    [amount * ramp(x, 0.55, 1.0) * ramp(y, 1.5, 1.9), 0.0, 0.0]
}

fn height([x, y, z]: Point, amount: f64) -> Point {
    scaled([-0.3 * x, y + 0.3, -0.3 * z], amount)
}

pub(crate) fn add(tree: &mut Tree) {
    let imp = imp::build();
    add_base(tree, &imp.mesh);
    add_targets(tree, &imp.mesh);
    add_rig(tree, &imp);
}

fn add_base(tree: &mut Tree, mesh: &Mesh) {
    let settings = json!({
        "visible groups": ["body"],
        "numverts": mesh.vertices.len(),
        "target-opposites": { "decr": "incr", "in": "out" },
        "equipment": [],
        "pose-skeleton": "default.mhskel",
        "mhm": "base.mhm",
        "measure": { "size": "none" },
    });
    let body_units = json!({
        "Rest": {},
        "HeadNod": { "group": "head", "bones": { "head": NOD }, "reverse": { "head": NOD_BACK } },
    });
    let face_units = json!({
        "Rest": {},
        "LeftEarRaise": {
            "group": "ears",
            "rsym": "RightEarRaise",
            "bones": { "ear.L": TURN },
            "reverse": { "ear.L": TURN_BACK },
        },
        "RightEarRaise": {
            "group": "ears",
            "lsym": "LeftEarRaise",
            "bones": { "ear.R": TURN_BACK },
            "reverse": { "ear.R": TURN },
        },
    });
    tree.add(format!("{BASE}/base.obj"), mesh.obj("imp"));
    tree.add(format!("{BASE}/base.json"), json_text::by_hand(&settings));
    tree.add(
        format!("{BASE}/base.mhm"),
        assets::start_model("imp", &[("macrodetails/ImpHeight", "0.5")]),
    );
    tree.add(
        format!("{BASE}/body-poses.json"),
        json_text::by_hand(&body_units),
    );
    tree.add(
        format!("{BASE}/face-poses.json"),
        json_text::by_hand(&face_units),
    );
}

fn add_targets(tree: &mut Tree, mesh: &Mesh) {
    let folder = PLACE.folder;
    for (name, amount) in [("short", -0.06), ("tall", 0.08)] {
        let field = |point: Point| height(point, amount);
        let text = target_text(mesh, PLACE.base, Side::Both, &field);
        tree.add(format!("{folder}/macro_height/{name}.target"), text);
    }
    let mut entries = json!({
        "Height": {
            "group": "main|body",
            "icon": "height.png",
            "macro": "macrodetails/ImpHeight",
            "macro_influence": [0],
            "default": 0.5,
        },
    });
    add_icon(tree, &PLACE, "height.png");
    let details = add_details(tree, mesh, &PLACE, &DETAILS);
    if let Value::Object(map) = &mut entries {
        map.extend(details);
    }
    tree.add(
        format!("{folder}/macro.json"),
        json_text::by_hand(&macros()),
    );
    tree.add(
        format!("{folder}/modelling.json"),
        json_text::by_hand(&entries),
    );
    let items = json!([{ "title": "Body", "cat": "body" }, { "title": "Ears", "cat": "ears" }]);
    let categories = json!({ "Main": { "group": "main", "items": items } });
    tree.add(
        format!("{folder}/target_cat.json"),
        json_text::by_hand(&categories),
    );
}

fn macros() -> Value {
    json!({
        "components": {
            "height": { "values": ["short", "tall"], "steps": [0.0, 1.0], "pattern": "macrodetails/ImpHeight" },
        },
        "macrodef": [
            { "name": "height", "comp": ["height"], "folder": "macro_height", "targets": [
                { "name": "short", "t": "short" },
                { "name": "tall", "t": "tall" },
            ] },
        ],
    })
}

fn add_rig(tree: &mut Tree, imp: &Imp) {
    let mesh = &imp.mesh;
    let mut influences = Vec::new();
    for group in &mesh.groups {
        for vertex in group.vertices.clone() {
            let x = group
                .cube
                .map_or(mesh.vertices[vertex][0], |(centre, _)| centre[0]);
            let shares = imp
                .grid
                .get(vertex)
                .map_or_else(|| joint_shares(group), |&(i, j, _)| body_shares(i, j));
            influences.push(rig::influences(&BONES, x, shares));
        }
    }
    tree.add(
        format!("{RIG}/default.mhskel"),
        rig::skeleton_text(mesh, &TITLE, &BONES, &PLANES),
    );
    tree.add(
        format!("{RIG}/default_weights.mhw"),
        rig::weights_text(&TITLE, &BONES, &influences),
    );
    tree.add(
        format!("{RIG}/default.thumb"),
        icon::png("imp skeleton", 64, 64),
    );
}

type Shares = &'static [(&'static str, f64)];

fn body_shares(side: i32, row: i32) -> Shares {
    match (side.abs(), row) {
        (2, _) => &[("ear", 1.0)],
        (1, 3 | 4) => &[("head", 0.75), ("ear", 0.25)],
        (_, 0 | 1) => &[("root", 1.0)],
        (_, 2) => &[("root", 0.5), ("head", 0.5)],
        _ => &[("head", 1.0)],
    }
}

fn joint_shares(group: &Group) -> Shares {
    match group.name.as_str() {
        "joint-base" => &[("root", 1.0)],
        "joint-middle" | "joint-top" => &[("head", 1.0)],
        _ => &[("ear", 1.0)],
    }
}
