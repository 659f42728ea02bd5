//! Skeleton (`.mhskel`) and weights (`.mhw`) of a base, from tables of bones, planes and a weight
//! function.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use crate::json_text;
use crate::mesh::Mesh;

/// A bone between two joints. Names of sided things end with `.L` or `.R`, those of joints start
/// with `l-` or `r-`.
pub(crate) struct Bone {
    pub(crate) name: &'static str,
    pub(crate) parent: Option<&'static str>,
    pub(crate) head: &'static str,
    pub(crate) tail: &'static str,
    pub(crate) plane: &'static str,
    pub(crate) sided: bool,
}

/// Three joints that fix the roll of bones.
pub(crate) struct Plane {
    pub(crate) name: &'static str,
    pub(crate) joints: [&'static str; 3],
    pub(crate) sided: bool,
}

/// What is said about the rig in both files.
pub(crate) struct Title {
    pub(crate) name: &'static str,
    pub(crate) description: &'static str,
    pub(crate) tags: &'static [&'static str],
}

/// Influences of one vertex: bone and share, exact in binary and with sum 1.
pub(crate) type Influences = Vec<(String, f64)>;

pub(crate) fn skeleton_text(
    mesh: &Mesh,
    title: &Title,
    bones: &[Bone],
    planes: &[Plane],
) -> String {
    let mut joints = Map::new();
    for group in mesh.groups.iter().filter(|group| group.cube.is_some()) {
        joints.insert(
            group.name.replace("joint-", ""),
            json!(group.vertices.clone().collect::<Vec<_>>()),
        );
    }
    let mut bone_map = Map::new();
    let mut plane_map = Map::new();
    for side in ["L", "R"] {
        for bone in bones.iter().filter(|bone| bone.sided || side == "L") {
            let entry = bone_entry(bone, bones, planes, side);
            bone_map.insert(on_side(bone.name, bone.sided, side), entry);
        }
        for plane in planes.iter().filter(|plane| plane.sided || side == "L") {
            plane_map.insert(
                on_side(plane.name, plane.sided, side),
                json!(plane.joints.map(|j| joint_on(j, side))),
            );
        }
    }
    json_text::by_hand(&json!({
        "name": title.name,
        "version": 110,
        "author": "mhlint",
        "copyright": "none, released as CC0",
        "license": "CC0",
        "description": title.description,
        "tags": title.tags,
        "weights_file": "default_weights.mhw",
        "bones": bone_map,
        "joints": joints,
        "planes": plane_map,
    }))
}

fn bone_entry(bone: &Bone, bones: &[Bone], planes: &[Plane], side: &str) -> Value {
    let parent_sided = bones
        .iter()
        .any(|other| Some(other.name) == bone.parent && other.sided);
    let plane_sided = planes
        .iter()
        .any(|plane| plane.name == bone.plane && plane.sided);
    json!({
        "head": joint_on(bone.head, side),
        "tail": joint_on(bone.tail, side),
        "parent": bone.parent.map(|name| on_side(name, parent_sided, side)),
        "rotation_plane": on_side(bone.plane, plane_sided, side),
    })
}

/// Weights of all vertices, bone by bone in the order of the skeleton.
pub(crate) fn weights_text(title: &Title, bones: &[Bone], influences: &[Influences]) -> String {
    let mut pairs: BTreeMap<&str, Vec<Value>> = BTreeMap::new();
    for (vertex, list) in influences.iter().enumerate() {
        for (bone, weight) in list {
            pairs.entry(bone).or_default().push(json!([vertex, weight]));
        }
    }
    let mut weights = Map::new();
    for side in ["L", "R"] {
        for bone in bones.iter().filter(|bone| bone.sided || side == "L") {
            let name = on_side(bone.name, bone.sided, side);
            let list = pairs.get(name.as_str()).cloned().unwrap_or_default();
            weights.insert(name, Value::Array(list));
        }
    }
    json_text::by_hand(&json!({
        "name": format!("{} weights", title.name),
        "version": 110,
        "license": "CC0",
        "description": format!("Symmetric weights for: {}", title.description),
        "weights": weights,
    }))
}

/// Influences of a vertex at `x`: sided bones get the side of the vertex, and half of the share
/// each on the centre line.
pub(crate) fn influences(bones: &[Bone], x: f64, shares: &[(&str, f64)]) -> Influences {
    let mut list = Influences::new();
    for &(name, share) in shares {
        let sided = bones.iter().any(|bone| bone.name == name && bone.sided);
        match (sided, x) {
            (false, _) => list.push((name.to_owned(), share)),
            (true, x) if x > 0.0 => list.push((format!("{name}.L"), share)),
            (true, x) if x < 0.0 => list.push((format!("{name}.R"), share)),
            (true, _) => {
                list.extend(["L", "R"].map(|side| (format!("{name}.{side}"), share / 2.0)));
            }
        }
    }
    list
}

fn on_side(name: &str, sided: bool, side: &str) -> String {
    if sided {
        format!("{name}.{side}")
    } else {
        name.to_owned()
    }
}

/// Joints of the tables are those of the left side.
fn joint_on(name: &str, side: &str) -> String {
    match name.strip_prefix("l-") {
        Some(rest) if side == "R" => format!("r-{rest}"),
        _ => name.to_owned(),
    }
}
