//! What the loader reads of a bone (`docs/loaders/mpfb/rigs.md#bone-keys`,
//! `docs/loaders/mpfb/rigs.md#bendy-bones`).

use super::attribute::{BENDY_BONE, Wants, check, triple, wanted};
use super::{BENDY, RigBone, RigFaults, constraint, end, layers, rigify};
use crate::unfit::{Why, below};
use mhlint_json::{Node, Value};

/// What is the same for all bones of a rig.
pub(super) struct Whole {
    /// Whether layers are read.
    pub has_layers: bool,
}

/// Keys without which the loader stops.
const NEEDED: [&str; 9] = [
    "head",
    "tail",
    "roll",
    "parent",
    "use_connect",
    "use_inherit_rotation",
    "use_local_location",
    "inherit_scale",
    "rigify",
];

const INHERITED: &[&str] = &[
    "FULL",
    "FIX_SHEAR",
    "ALIGNED",
    "AVERAGE",
    "NONE",
    "NONE_LEGACY",
];
const ROTATION_MODES: &[&str] = &[
    "QUATERNION",
    "XYZ",
    "XZY",
    "YXZ",
    "YZX",
    "ZXY",
    "ZYX",
    "AXIS_ANGLE",
];
const ROLL_STRATEGIES: &[&str] = &["ALIGN_Z_WORLD_Z", "ALIGN_X_WORLD_X", "ALIGN_Z_REFERENCE_Z"];

/// Keys with values of one type, and what they take.
const PLAIN: [(&str, Wants); 6] = [
    ("roll", Wants::Number),
    ("use_connect", Wants::Bool),
    ("use_inherit_rotation", Wants::Bool),
    ("use_local_location", Wants::Bool),
    ("inherit_scale", Wants::Word(INHERITED)),
    ("rotation_mode", Wants::Word(ROTATION_MODES)),
];

/// Reads a bone.
pub(super) fn read(
    name: &str,
    pointer: &str,
    node: &Node,
    whole: &Whole,
    faults: &mut RigFaults,
) -> RigBone {
    let mut bone = RigBone {
        name: name.to_owned(),
        ..RigBone::default()
    };
    if !node.is_object() {
        faults.keys.add_type(pointer, node, "an object");
        return bone;
    }
    for key in NEEDED.into_iter().filter(|key| node.get(key).is_none()) {
        faults.keys.add(pointer, Why::Lacks(key));
    }
    for (key, wants) in PLAIN {
        if let Some(value) = node.get(key) {
            check(
                &below(pointer, key),
                value,
                wants,
                &mut faults.keys,
                &mut faults.words,
            );
        }
    }
    let text = |key| node.get(key).and_then(Node::as_str).map(str::to_owned);
    bone.head = place(pointer, "head", node, faults);
    bone.tail = place(pointer, "tail", node, faults);
    bone.roll = node
        .get("roll")
        .and_then(Node::as_python_number)
        .unwrap_or(0.0);
    bone.roll_strategy = text("roll_strategy");
    bone.roll_reference_z = node.get("roll_reference_z").and_then(triple);
    bone.parent = text("parent").filter(|parent| !parent.is_empty());
    bone.use_connect = node
        .get("use_connect")
        .is_some_and(|value| !value.is_falsy());
    bone.inherit_scale = text("inherit_scale").unwrap_or_default();
    bone.rotation_mode = text("rotation_mode");
    if let Some(strategy) = node.get("roll_strategy") {
        faults.ignored_words.check_word(
            &below(pointer, "roll_strategy"),
            strategy,
            ROLL_STRATEGIES,
        );
    }
    if let Some(parent) = node
        .get("parent")
        .filter(|parent| !parent.is_falsy() && parent.as_str().is_none())
    {
        faults
            .keys
            .add_type(&below(pointer, "parent"), parent, "a text");
    }
    bone.collections = collections(pointer, node, whole, faults);
    layers::check(pointer, node, whole.has_layers, &mut faults.layers);
    bendy(pointer, node, &mut bone, faults);
    if let Some(rigify) = node.get("rigify") {
        rigify::of_bone(&below(pointer, "rigify"), rigify, whole, &mut bone, faults);
    }
    if let Some(list) = node.get("constraints") {
        let pointer = below(pointer, "constraints");
        if !list.is_array() {
            faults.keys.add_type(&pointer, list, "a list");
        }
        bone.constraints = constraint::read(&pointer, list, faults);
    }
    bone
}

fn place(pointer: &str, key: &str, node: &Node, faults: &mut RigFaults) -> Option<end::End> {
    let (pointer, node) = (below(pointer, key), node.get(key)?);
    if !node.is_object() {
        faults.keys.add_type(&pointer, node, "an object");
        return None;
    }
    Some(end::read(&pointer, node, &mut faults.ends))
}

/// A text is taken letter by letter.
fn collections(pointer: &str, node: &Node, whole: &Whole, faults: &mut RigFaults) -> Vec<String> {
    let Some(list) = node
        .get("collections")
        .filter(|list| !list.is_falsy() && !whole.has_layers)
    else {
        return Vec::new();
    };
    names(&below(pointer, "collections"), list, faults)
}

/// Names in a list; a text is one of letters.
pub(super) fn names(pointer: &str, list: &Node, faults: &mut RigFaults) -> Vec<String> {
    match &list.value {
        Value::Null => Vec::new(),
        Value::String(text) => text.chars().map(String::from).collect(),
        Value::Array(names) if names.iter().all(|name| name.as_str().is_some()) => names
            .iter()
            .filter_map(Node::as_str)
            .map(str::to_owned)
            .collect(),
        _ => {
            faults.keys.add_type(pointer, list, "a list of names");
            Vec::new()
        }
    }
}

/// How a bone is bent.
fn bendy(pointer: &str, node: &Node, bone: &mut RigBone, faults: &mut RigFaults) {
    let Some(bendy) = node.get("bendy_bone") else {
        return;
    };
    let pointer = below(pointer, "bendy_bone");
    if !bendy.is_object() {
        faults.keys.add_type(&pointer, bendy, "an object");
    }
    for member in bendy.effective_members() {
        let place = below(&pointer, &member.key);
        let handle = ["custom_handle_start", "custom_handle_end"]
            .into_iter()
            .find(|key| *key == member.key);
        match (handle, wanted(BENDY_BONE, &member.key)) {
            (Some(key), _) => match member.node.as_str() {
                Some(name) => bone.handles.push((key, name.to_owned())),
                None => faults
                    .properties
                    .add_type(&place, &member.node, "the name of a bone"),
            },
            (None, Some(wants)) => check(
                &place,
                &member.node,
                wants,
                &mut faults.keys,
                &mut faults.words,
            ),
            (None, None) => faults.properties.add(&place, Why::Key(BENDY)),
        }
    }
    bone.segments = bendy.get("segments").and_then(Node::as_python_number);
}
