//! User targets for `figure`, and the two files that `MakeHuman` 2 generates for them.
//!
//! The rules of the generation are those of
//! `docs/loaders/makehuman2/user-targets.md#names-and-keys`, for names that stand in one
//! sub-folder.

use serde_json::{Map, Value, json};

use crate::fields;
use crate::json_text;
use crate::mesh::{Mesh, Point};
use crate::morph::{Side, target_text};
use crate::slider::{Place, add_icon};
use crate::tree::Tree;

const PLACE: Place = Place {
    base: "figure",
    folder: "user/target/figure",
};

struct UserTarget {
    folder: &'static str,
    stem: &'static str,
    field: fn(Point, f64) -> Point,
    amount: f64,
}

const TARGETS: [UserTarget; 5] = [
    UserTarget {
        folder: "neck",
        stem: "neck-height-decr",
        field: fields::neck_height,
        amount: -0.1,
    },
    UserTarget {
        folder: "neck",
        stem: "neck-height-incr",
        field: fields::neck_height,
        amount: 0.1,
    },
    UserTarget {
        folder: "shape",
        stem: "shape-slim",
        field: fields::bulk,
        amount: -0.04,
    },
    UserTarget {
        folder: "waist",
        stem: "waist-depth-decr",
        field: fields::waist_depth,
        amount: -0.08,
    },
    UserTarget {
        folder: "waist",
        stem: "waist-depth-incr",
        field: fields::waist_depth,
        amount: 0.08,
    },
];

pub(crate) fn add(tree: &mut Tree, mesh: &Mesh) {
    let mut entries = Map::new();
    let mut items: Vec<Value> = Vec::new();
    for target in &TARGETS {
        let field = |point: Point| (target.field)(point, target.amount);
        let text = target_text(mesh, PLACE.base, Side::Both, &field);
        tree.add(
            format!("{}/{}/{}.target", PLACE.folder, target.folder, target.stem),
            text,
        );
        if items.iter().all(|item| item["cat"] != target.folder) {
            items.push(json!({ "title": capitalized(target.folder), "cat": target.folder }));
        }
        if let Some((key, entry)) = entry(target) {
            add_icon(tree, &PLACE, entry["icon"].as_str().unwrap_or_default());
            entries.insert(key, entry);
        }
    }
    let categories = json!({ "User": { "group": "user", "items": items } });
    tree.add(
        format!("{}/modelling.json", PLACE.folder),
        json_text::by_program(&Value::Object(entries)),
    );
    tree.add(
        format!("{}/target_cat.json", PLACE.folder),
        json_text::by_program(&categories),
    );
}

/// The generated entry; a `-decr` file belongs to that of its `-incr` partner.
fn entry(target: &UserTarget) -> Option<(String, Value)> {
    let (folder, stem) = (target.folder, target.stem);
    if stem.ends_with("-decr") {
        return None;
    }
    let shown = stem.strip_suffix("-incr").unwrap_or(stem);
    let name = shown.replace('-', " ");
    let mut value = json!({
        "user": 1,
        "name": name,
        "group": format!("user|{folder}"),
        "icon": format!("{folder}-{shown}.png"),
        "incr": format!("{folder}/{stem}"),
    });
    if shown != stem {
        value["decr"] = json!(format!("{folder}/{shown}-decr"));
    }
    Some((
        format!("{} {}", capitalized(folder), capitalized(&name)),
        value,
    ))
}

/// Python's `str.capitalize` for the ASCII names used here.
fn capitalized(name: &str) -> String {
    let (first, rest) = name.split_at(1);
    first.to_uppercase() + &rest.to_lowercase()
}
