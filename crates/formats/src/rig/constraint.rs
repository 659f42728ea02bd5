//! Constraints of a bone: every key is a property of Blender's constraint of that type
//! (`docs/loaders/mpfb/rigs.md#faults-of-constraints`).

use super::RigFaults;
use super::attribute::{Properties, Wants, check, wanted};
use super::constraint_types::{COMMON, NAMES, TYPES};
use crate::unfit::{Why, below, nth};
use mhlint_json::{Node, Value};

/// What binds a bone to others.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// Pointer to it.
    pub pointer: String,
    /// Its type.
    pub kind: String,
    /// What it is bound to, each with the bone that is named there.
    pub targets: Vec<(Target, Option<String>)>,
    /// How much of it counts, if that is said.
    pub influence: Option<f64>,
}

/// What a constraint is bound to.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// The rig itself.
    Own,
    /// Nothing.
    Missing,
    /// The parent rig, with the bone as it is named.
    Parent,
    /// The bone of the parent rig between two joints: pointer, head and tail.
    Span(String, String, String),
    /// What moves a vertex of the base mesh.
    Vertex,
    /// Nothing that the loader takes.
    Unfit,
}

/// The names of properties of a type.
fn names_of(properties: Properties) -> Vec<&'static str> {
    COMMON
        .iter()
        .chain(properties)
        .map(|(names, _)| *names)
        .collect()
}

/// Keys that are not set as properties.
const OWN_KEYS: [&str; 5] = ["type", "name", "target", "targets", "space_object"];

/// The constraints of a bone.
pub(super) fn read(pointer: &str, list: &Node, faults: &mut RigFaults) -> Vec<Constraint> {
    let each = list.elements().iter().enumerate();
    each.filter_map(|(at, node)| one(nth(pointer, at), node, faults))
        .collect()
}

fn one(pointer: String, node: &Node, faults: &mut RigFaults) -> Option<Constraint> {
    if !node.is_object() {
        faults.keys.add_type(&pointer, node, "an object");
        return None;
    }
    for key in ["type", "name"] {
        match node.get(key) {
            None => faults.keys.add(&pointer, Why::Lacks(key)),
            Some(text) if text.as_str().is_none() => {
                faults.keys.add_type(&below(&pointer, key), text, "a text");
            }
            Some(_) => {}
        }
    }
    let kind = node.get("type").and_then(Node::as_str)?;
    let Some((_, has_target, properties)) = TYPES.iter().find(|(name, ..)| *name == kind) else {
        faults
            .words
            .add(&below(&pointer, "type"), Why::Word(kind.to_owned(), NAMES));
        return None;
    };
    for member in node
        .effective_members()
        .into_iter()
        .filter(|member| !OWN_KEYS.contains(&&*member.key))
    {
        let place = below(&pointer, &member.key);
        match wanted(properties, &member.key).or_else(|| wanted(COMMON, &member.key)) {
            Some(wants) if !matches!(wants, Wants::Nothing) => {
                check(
                    &place,
                    &member.node,
                    wants,
                    &mut faults.keys,
                    &mut faults.words,
                );
            }
            _ => faults
                .properties
                .add(&place, Why::Property(names_of(properties))),
        }
    }
    let targets = targets(&pointer, node, kind, *has_target, faults);
    let influence = node.get("influence").and_then(Node::as_f64);
    Some(Constraint {
        pointer,
        kind: kind.to_owned(),
        targets,
        influence,
    })
}

fn targets(
    pointer: &str,
    node: &Node,
    kind: &str,
    has_target: bool,
    faults: &mut RigFaults,
) -> Vec<(Target, Option<String>)> {
    let bone = |node: &Node| {
        node.get("subtarget")
            .and_then(Node::as_str)
            .map(str::to_owned)
    };
    if kind == "ARMATURE" {
        return of_armature(pointer, node, faults);
    }
    let found = target(&below(pointer, "target"), node.get("target"), faults);
    if !has_target {
        if matches!(found, Target::Own | Target::Parent | Target::Span(..)) {
            faults
                .properties
                .add(&below(pointer, "target"), Why::Property(Vec::new()));
        }
        return Vec::new();
    }
    // Some are bound to whole objects: what bone is named does not matter to them.
    if !TYPES
        .iter()
        .any(|(name, _, properties)| *name == kind && wanted(properties, "subtarget").is_some())
    {
        return Vec::new();
    }
    vec![(found, bone(node))]
}

fn of_armature(
    pointer: &str,
    node: &Node,
    faults: &mut RigFaults,
) -> Vec<(Target, Option<String>)> {
    let vertex = node.get("target").filter(|target| target.is_object());
    if let Some(vertex) = vertex {
        let strategy = vertex.get("strategy").and_then(Node::as_str);
        if strategy != Some("VERTEX") {
            faults.keys.add_type(
                &below(pointer, "target"),
                vertex,
                "a vertex of the base mesh",
            );
        }
    }
    let Some(targets) = node.get("targets") else {
        if vertex.is_none() {
            faults.keys.add(pointer, Why::Lacks("targets"));
        }
        return Vec::new();
    };
    let pointer = below(pointer, "targets");
    if !targets.is_array() {
        faults.keys.add_type(&pointer, targets, "a list");
    }
    let mut found = Vec::new();
    for (at, one) in targets.elements().iter().enumerate() {
        let pointer = nth(&pointer, at);
        for key in ["subtarget", "weight"]
            .into_iter()
            .filter(|key| one.get(key).is_none())
        {
            faults.keys.add(&pointer, Why::Lacks(key));
        }
        let bone = one
            .get("subtarget")
            .and_then(Node::as_str)
            .map(str::to_owned);
        let own = one.get("target").is_none();
        let target = if own {
            Target::Own
        } else {
            target(&below(&pointer, "target"), one.get("target"), faults)
        };
        found.push((target, bone));
    }
    found
}

fn target(pointer: &str, node: Option<&Node>, faults: &mut RigFaults) -> Target {
    let Some(node) = node else {
        return Target::Missing;
    };
    match &node.value {
        Value::Bool(true) => Target::Own,
        Value::Object(_) => of_parent(pointer, node, faults),
        _ if node.is_falsy() => Target::Missing,
        Value::Array(_) => Target::Missing,
        _ => {
            faults.keys.add_type(pointer, node, "`true` or `false`");
            Target::Unfit
        }
    }
}

/// What a sub-rig names of the rig that it is added to
/// (`docs/loaders/mpfb/custom-rigs.md#references-to-the-parent-rig`).
fn of_parent(pointer: &str, node: &Node, faults: &mut RigFaults) -> Target {
    let Some(strategy) = node.get("strategy") else {
        faults.keys.add(pointer, Why::Lacks("strategy"));
        return Target::Unfit;
    };
    match (strategy.as_str(), &strategy.value) {
        (_, Value::Null) => Target::Parent,
        (Some("VERTEX"), _) => Target::Vertex,
        (Some("JOINTS"), _) => {
            let joint = |key: &'static str| node.get(key).and_then(Node::as_str).map(str::to_owned);
            for key in ["joint_head", "joint_tail"]
                .into_iter()
                .filter(|key| node.get(key).is_none())
            {
                faults.keys.add(pointer, Why::Lacks(key));
            }
            match (joint("joint_head"), joint("joint_tail")) {
                (Some(head), Some(tail)) => Target::Span(pointer.to_owned(), head, tail),
                _ => Target::Unfit,
            }
        }
        (text, _) => {
            let text = text.unwrap_or(strategy.type_word()).to_owned();
            faults.words.add(
                &below(pointer, "strategy"),
                Why::Word(text, &["JOINTS", "VERTEX"]),
            );
            Target::Unfit
        }
    }
}
