//! `.mhskel`: joints, planes and bones of a skeleton (formats/makehuman2.md §10).

use serde::Serialize;

use super::macro_json::{text, texts};
use super::modelling::integers;
use crate::json::{Document, Node, Value};

/// The file.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Skeleton {
    /// Name, also its identity in the asset library.
    pub name: Option<String>,
    /// Whether the obligatory sections are there.
    pub has_joints: bool,
    /// Whether the obligatory sections are there.
    pub has_bones: bool,
    /// Joints in file order.
    pub joints: Vec<Joint>,
    /// Planes in file order.
    pub planes: Vec<Plane>,
    /// Bones in file order.
    pub bones: Vec<Bone>,
    /// `weights_file` as written.
    pub weights_file: Option<String>,
}

/// A joint.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Vertices whose mean it is; `None` if it is no list of integers.
    pub vertices: Option<Vec<i64>>,
}

/// A plane.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Plane {
    /// Its name.
    pub name: String,
    /// Names of its joints, `None` in place of `null` and other types; `None` as a whole if it is no list.
    pub joints: Option<Vec<Option<String>>>,
}

/// A bone.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Bone {
    /// Its name.
    pub name: String,
    /// Joint at its beginning.
    pub head: Option<String>,
    /// Joint at its end.
    pub tail: Option<String>,
    /// Parent bone; `None` for a root.
    pub parent: Option<String>,
    /// Plane that gives its roll.
    pub rotation_plane: RotationPlane,
    /// Bones of the default skeleton whose weights and pose it takes.
    pub reference: Option<Vec<String>>,
    /// The same for weights alone.
    pub weights_reference: Option<Vec<String>>,
}

/// `rotation_plane` of a bone.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub enum RotationPlane {
    /// The key is missing: the normal is (0, 1, 0).
    Absent,
    /// The name of a plane.
    Named(String),
    /// `[null, null, null]`, or something else that is no text.
    Malformed,
}

/// Takes what the loader would take.
pub fn read(document: &Document) -> Skeleton {
    let root = &document.root;
    Skeleton {
        name: text(root, "name"),
        has_joints: root.get("joints").is_some(),
        has_bones: root.get("bones").is_some(),
        joints: members(root, "joints", |name, node| Joint { name, vertices: vertices(node) }),
        planes: members(root, "planes", |name, node| Plane { name, joints: plane_joints(node) }),
        bones: members(root, "bones", bone),
        weights_file: text(root, "weights_file"),
    }
}

fn members<T>(root: &Node, key: &str, read: impl Fn(String, &Node) -> T) -> Vec<T> {
    let members = root.get(key).map(Node::effective_members).unwrap_or_default();
    let members = members.into_iter();
    members.map(|member| read(member.key.clone(), &member.node)).collect()
}

fn vertices(node: &Node) -> Option<Vec<i64>> {
    integers(node).filter(|vertices| vertices.len() == node.elements().len())
}

fn plane_joints(node: &Node) -> Option<Vec<Option<String>>> {
    let elements = node.is_array().then(|| node.elements())?;
    Some(elements.iter().map(|joint| joint.as_str().map(str::to_owned)).collect())
}

fn bone(name: String, node: &Node) -> Bone {
    Bone {
        name,
        head: text(node, "head"),
        tail: text(node, "tail"),
        parent: text(node, "parent"),
        rotation_plane: match node.get("rotation_plane").map(|plane| &plane.value) {
            None => RotationPlane::Absent,
            Some(Value::String(plane)) => RotationPlane::Named(plane.clone()),
            Some(_) => RotationPlane::Malformed,
        },
        reference: node.get("reference").and_then(texts),
        weights_reference: node.get("weights_reference").and_then(texts),
    }
}
