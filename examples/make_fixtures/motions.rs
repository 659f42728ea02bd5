//! What the figure does: a pose, an expression, a motion with what is said of it, and models.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::icon;
use crate::json_text;
use crate::tree::Tree;
use crate::wardrobe::{BEADS, BLOCKS, CURLS, GRIN, KILT, SHIRT};

pub(crate) fn add(tree: &mut Tree) {
    let lean = json!({ "SpineBend": 0.5, "LeftUpperArmRaise": -0.25, "RightUpperArmRaise": -0.25 });
    add_pose(tree, "poses", "lean", "leans forward", &lean);
    add_pose(
        tree,
        "expressions",
        "puzzled",
        "holds the head askew",
        &json!({ "HeadTilt": 0.4 }),
    );
    let motion = "data/poses/figure/nod";
    tree.add(format!("{motion}.bvh"), nod());
    tree.add(
        format!("{motion}.meta"),
        "name nod twice\nauthor mhlint\ntag greeting\n",
    );
    tree.add(format!("{motion}.thumb"), icon::png("nod", 32, 32));
    add_model(tree, "visitor", &visitor());
    add_model(
        tree,
        "statue",
        &format!("proxy blocks {BLOCKS}\nskinMaterial skins/clay.mhmat\nskeleton default.mhskel\n"),
    );
}

fn add_pose(tree: &mut Tree, folder: &str, name: &str, description: &str, units: &Value) {
    let pose = json!({
        "name": name,
        "author": "mhlint",
        "license": "CC0",
        "description": description,
        "tags": ["example"],
        "unit_poses": units,
    });
    tree.add(
        format!("data/{folder}/figure/{name}.mhpose"),
        json_text::by_hand(&pose),
    );
    tree.add(
        format!("data/{folder}/figure/{name}.thumb"),
        icon::png(name, 32, 32),
    );
}

/// Joints in a line, which is how far the head hangs from the root.
const JOINTS: [(&str, f64); 5] = [
    ("root", 0.0),
    ("spine", 0.95),
    ("chest", 0.95),
    ("neck", 1.1),
    ("head", 0.55),
];

fn nod() -> String {
    let mut text = String::from("HIERARCHY\n");
    for (depth, (name, up)) in JOINTS.into_iter().enumerate() {
        let (indent, word) = (
            "  ".repeat(depth),
            if depth == 0 { "ROOT" } else { "JOINT" },
        );
        let channels = if depth == 0 {
            "6 Xposition Yposition Zposition"
        } else {
            "3"
        };
        let _ = writeln!(
            text,
            "{indent}{word} {name}\n{indent}{{\n{indent}  OFFSET 0 0 {up}"
        );
        let _ = writeln!(
            text,
            "{indent}  CHANNELS {channels} Xrotation Yrotation Zrotation"
        );
    }
    let indent = "  ".repeat(JOINTS.len());
    let _ = writeln!(
        text,
        "{indent}End Site\n{indent}{{\n{indent}  OFFSET 0 0 1.3\n{indent}}}"
    );
    for depth in (0..JOINTS.len()).rev() {
        let _ = writeln!(text, "{}}}", "  ".repeat(depth));
    }
    text.push_str("MOTION\nFrames: 3\nFrame Time: 0.04\n");
    for angle in [0, 12, 4] {
        let _ = writeln!(text, "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 {angle} 0 0");
    }
    text
}

fn add_model(tree: &mut Tree, name: &str, lines: &str) {
    let head = format!(
        "# Model of the mhlint example repository, released as CC0\nversion v2.0.1\nname {name}\nauthor mhlint\n"
    );
    let modifiers = "modifier macrodetails/Gender 0.4\nmodifier macrodetails/Age 0.55\n";
    tree.add(
        format!("data/models/figure/{name}.mhm"),
        format!("{head}tags example\n{modifiers}{lines}"),
    );
    tree.add(
        format!("data/models/figure/{name}.thumb"),
        icon::png(name, 32, 32),
    );
}

fn visitor() -> String {
    format!(
        "clothes kilt {KILT}\nclothes shirt {SHIRT}\nhair curls {CURLS}\neyes beads {BEADS}\nteeth grin {GRIN}\n\
        skinMaterial skins/copper/copper.mhmat\nskeleton default.mhskel\nmaterial shirt {SHIRT} shirt_green.mhmat\n\
        material beads {BEADS} eyes/materials/amber.mhmat\n"
    )
}
