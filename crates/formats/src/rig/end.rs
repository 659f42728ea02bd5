//! Ends of a bone: where they lie on the mesh (`docs/loaders/mpfb/rigs.md#positions`).

use super::attribute::triple;
use crate::unfit::{Unfits, Why, below, nth};
use mhlint_json::{Node, Value};

/// An end of a bone.
#[derive(Debug, Clone, PartialEq)]
pub struct End {
    /// How its place is found.
    pub strategy: Strategy,
    /// What is added to it.
    pub offset: [f64; 3],
    /// Where it is if it is not found.
    pub default_position: DefaultPosition,
}

/// How the place of an end is found.
#[derive(Debug, Clone, PartialEq)]
pub enum Strategy {
    /// Mean of the vertices of a group.
    Cube(String),
    /// A vertex.
    Vertex(i64),
    /// Mean of some.
    Mean(Vec<i64>),
    /// x of the first, y of the second, z of the third.
    Xyz(Vec<i64>),
    /// None of these: what stands there.
    Unknown(String),
    /// It names one of these, and lacks or mistypes what that needs: the loader stops.
    Unfit,
}

/// Where an end is if its place is not found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DefaultPosition {
    /// It does not say.
    Absent,
    /// Not three numbers.
    Unfit,
    /// Here, in Blender's axes and metres.
    At([f64; 3]),
}

/// What a loader reads of an end.
pub(super) fn read(pointer: &str, node: &Node, faults: &mut Unfits) -> End {
    let default_position = match node.get("default_position") {
        None => DefaultPosition::Absent,
        Some(node) => triple(node).map_or(DefaultPosition::Unfit, DefaultPosition::At),
    };
    End {
        strategy: strategy(pointer, node, faults),
        offset: offset(pointer, node, faults),
        default_position,
    }
}

fn offset(pointer: &str, node: &Node, faults: &mut Unfits) -> [f64; 3] {
    let Some(offset) = node.get("offset") else {
        return [0.0; 3];
    };
    triple(offset).unwrap_or_else(|| {
        faults.add_type(&below(pointer, "offset"), offset, "a list of 3 numbers");
        [0.0; 3]
    })
}

fn strategy(pointer: &str, node: &Node, faults: &mut Unfits) -> Strategy {
    let Some(name) = node.get("strategy") else {
        faults.add(pointer, Why::Lacks("strategy"));
        return Strategy::Unfit;
    };
    let read = match name.as_str() {
        Some("CUBE") => field(pointer, node, "cube_name", faults).map(cube),
        Some("VERTEX") => {
            let vertex = field(pointer, node, "vertex_index", faults);
            vertex
                .and_then(|node| index(&below(pointer, "vertex_index"), node, faults))
                .map(Strategy::Vertex)
        }
        Some("MEAN") => indices(pointer, node, faults).map(Strategy::Mean),
        Some("XYZ") => indices(pointer, node, faults).map(Strategy::Xyz),
        Some(other) => Some(Strategy::Unknown(other.to_owned())),
        None => Some(Strategy::Unknown(name.type_word().to_owned())),
    };
    read.unwrap_or(Strategy::Unfit)
}

/// What is no text names no cube.
fn cube(node: &Node) -> Strategy {
    Strategy::Cube(
        node.as_str()
            .map_or_else(|| node.type_word().to_owned(), str::to_owned),
    )
}

fn field<'n>(
    pointer: &str,
    node: &'n Node,
    key: &'static str,
    faults: &mut Unfits,
) -> Option<&'n Node> {
    let found = node.get(key);
    if found.is_none() {
        faults.add(pointer, Why::Lacks(key));
    }
    found
}

fn indices(pointer: &str, node: &Node, faults: &mut Unfits) -> Option<Vec<i64>> {
    let list = field(pointer, node, "vertex_indices", faults)?;
    let pointer = below(pointer, "vertex_indices");
    if !list.is_array() {
        faults.add_type(&pointer, list, "a list of whole numbers");
        return None;
    }
    let elements = list.elements().iter().enumerate();
    let indices: Vec<Option<i64>> = elements
        .map(|(at, one)| index(&nth(&pointer, at), one, faults))
        .collect();
    indices.into_iter().collect()
}

fn index(pointer: &str, node: &Node, faults: &mut Unfits) -> Option<i64> {
    match node.value {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "written as an integer; no mesh has as many vertices"
        )]
        Value::Number(number, true) => Some(number as i64),
        Value::Bool(set) => Some(i64::from(set)),
        _ => {
            faults.add_type(pointer, node, "a whole number");
            None
        }
    }
}
