//! The folder `base/figure`: mesh, `base.json`, start model, geometry ranges and pose units.

use serde_json::{Map, Value, json};

use crate::assets::{self, NOD, NOD_BACK, TURN, TURN_BACK};
use crate::figure::Body;
use crate::json_text;
use crate::mesh::Mesh;
use crate::tree::Tree;

const FOLDER: &str = "data/base/figure";

pub(crate) fn add(tree: &mut Tree, body: &Body) {
    let mesh = &body.mesh;
    tree.add(format!("{FOLDER}/base.obj"), mesh.obj("figure"));
    tree.add(
        format!("{FOLDER}/base.json"),
        json_text::by_hand(&settings(mesh.vertices.len())),
    );
    tree.add(
        format!("{FOLDER}/base.mhm"),
        assets::start_model("figure", &START),
    );
    tree.add(
        format!("{FOLDER}/geometry.json"),
        json_text::by_hand(&geometry(mesh)),
    );
    tree.add(
        format!("{FOLDER}/body-poses.json"),
        json_text::by_hand(&body_units()),
    );
    tree.add(
        format!("{FOLDER}/face-poses.json"),
        json_text::by_hand(&face_units()),
    );
}

const START: [(&str, &str); 4] = [
    ("macrodetails/Gender", "0.5"),
    ("macrodetails/Age", "0.5"),
    ("macrodetails-universal/Muscle", "0.5"),
    ("torso/belly-trans-in|out", "-0.1"),
];

fn settings(vertices: usize) -> Value {
    json!({
        "visible groups": ["body"],
        "numverts": vertices,
        "target-opposites": { "decr": "incr", "in": "out", "down": "up", "backward": "forward" },
        "equipment": ["clothes", "hair", "eyes", "teeth", "proxy"],
        "pose-skeleton": "default.mhskel",
        "mhm": "base.mhm",
        "measure": {
            "gender": "macrodetails/Gender",
            "age": "macrodetails/Age",
            "size": "none",
            "waist": "measure/measure-waist-circ-decr|incr",
            "hips": "measure/measure-hips-circ-decr|incr",
        },
        "random": {
            "nonsym": [],
            "gender": "Gender",
            "ideal": "Muscle",
            "groups": {
                "main": true,
                "face": true,
                "torso|torso": true,
                "torso|belly": false,
                "arms": true,
                "legs": true,
                "measure": false,
            },
            "rules": { "Head Oval": { "Gender": "x < 0.5", "Age": "0.2 < x < 0.75" } },
        },
        "head-pattern": ["face|"],
        "modifier-presets": {
            "macrodetails/Gender": 0.5,
            "macrodetails/Age": 0.5,
            "macrodetails-universal/Muscle": 0.5,
            "macrodetails/Coastal": 0.33,
            "macrodetails/Highland": 0.33,
            "macrodetails/Woodland": 0.34,
        },
    })
}

fn geometry(mesh: &Mesh) -> Value {
    let (mut ranges, mut joints) = (Map::new(), Map::new());
    for group in &mesh.groups {
        let (first, last) = (group.vertices.start, group.vertices.end - 1);
        match group.cube {
            None => ranges.insert(group.name.clone(), json!([first, last])),
            Some((_, half)) => {
                joints.insert(group.name.replace("joint-", ""), json!([first, last, half]))
            }
        };
    }
    json!({ "geometry-ranges": ranges, "joint-ranges": joints })
}

fn body_units() -> Value {
    json!({
        "Rest": {},
        "Vertical Position": { "group": "root", "position": { "direction": "y", "boundaries": [-10.0, 10.0] } },
        "LeftUpperArmRaise": {
            "group": "arms",
            "rsym": "RightUpperArmRaise",
            "bones": { "upperarm.L": TURN },
            "reverse": { "upperarm.L": TURN_BACK },
        },
        "RightUpperArmRaise": {
            "group": "arms",
            "lsym": "LeftUpperArmRaise",
            "bones": { "upperarm.R": TURN_BACK },
            "reverse": { "upperarm.R": TURN },
        },
        "SpineBend": { "group": "spine", "bones": { "spine": NOD }, "reverse": { "spine": NOD_BACK } },
    })
}

fn face_units() -> Value {
    json!({
        "Rest": {},
        "HeadTilt": { "group": "head", "bones": { "head": TURN }, "reverse": { "head": TURN_BACK } },
    })
}
