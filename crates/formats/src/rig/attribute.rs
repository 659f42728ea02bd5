//! Values that Blender sets as they stand: of which type each has to be.

use crate::unfit::{Unfits, is_number};
use mhlint_json::{Node, Value};

/// What a property takes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Wants {
    /// `true`, `false`, 1 or 0.
    Bool,
    /// A whole number.
    Whole,
    /// Any number.
    Number,
    /// A text.
    Text,
    /// One of some words.
    Word(&'static [&'static str]),
    /// So many numbers.
    Numbers(usize),
    /// So many of `true` or `false`.
    Bools(usize),
    /// Something that no JSON can say.
    Nothing,
}

/// Names of properties, with blanks between them, and what they take.
pub(super) type Properties = &'static [(&'static str, Wants)];

const HANDLES: &[&str] = &["AUTO", "ABSOLUTE", "RELATIVE", "TANGENT"];

/// The keys of `bendy_bone` but for the custom handles (`docs/loaders/mpfb/rigs.md#bendy-bones`).
pub(super) const BENDY_BONE: Properties = &[
    ("segments", Wants::Whole),
    ("mapping_mode", Wants::Word(&["STRAIGHT", "CURVED"])),
    ("handle_type_start handle_type_end", Wants::Word(HANDLES)),
    ("handle_use_ease_start handle_use_ease_end", Wants::Bool),
    (
        "handle_use_scale_start handle_use_scale_end",
        Wants::Bools(3),
    ),
    (
        "easein easeout rollin rollout curveinx curveinz curveoutx curveoutz x z",
        Wants::Number,
    ),
    ("scalein scaleout", Wants::Numbers(3)),
];

/// All keys of `bendy_bone`.
pub const BENDY: &[&str] = &[
    "segments",
    "mapping_mode",
    "handle_type_start",
    "handle_type_end",
    "custom_handle_start",
    "custom_handle_end",
    "handle_use_ease_start",
    "handle_use_ease_end",
    "handle_use_scale_start",
    "handle_use_scale_end",
    "easein",
    "easeout",
    "rollin",
    "rollout",
    "curveinx",
    "curveinz",
    "curveoutx",
    "curveoutz",
    "x",
    "z",
    "scalein",
    "scaleout",
];

/// What a property takes; `None` if there is no such one.
pub(super) fn wanted(properties: Properties, key: &str) -> Option<Wants> {
    properties
        .iter()
        .find(|(names, _)| names.split(' ').any(|name| name == key))
        .map(|(_, wants)| *wants)
}

/// Checks a value; what does not fit goes to `types`, an unknown word to `words`.
pub(super) fn check(
    pointer: &str,
    node: &Node,
    wants: Wants,
    types: &mut Unfits,
    words: &mut Unfits,
) {
    let wanted = match wants {
        Wants::Bool if is_bool(node) => return,
        Wants::Whole if matches!(node.value, Value::Number(_, true) | Value::Bool(_)) => return,
        Wants::Number if is_number(node) => return,
        Wants::Text if node.as_str().is_some() => return,
        Wants::Word(known) if node.as_str().is_some() => {
            return words.check_word(pointer, node, known);
        }
        Wants::Numbers(count) if is_list(node, count, is_number) => return,
        Wants::Bools(count) if is_list(node, count, is_bool) => return,
        Wants::Bool => "`true` or `false`",
        Wants::Whole => "a whole number",
        Wants::Number => "a number",
        Wants::Text | Wants::Word(_) => "a text",
        Wants::Numbers(2) => "a list of 2 numbers",
        Wants::Numbers(_) => "a list of 3 numbers",
        Wants::Bools(2) => "a list of 2 of `true` or `false`",
        Wants::Bools(4) => "a list of 4 of `true` or `false`",
        Wants::Bools(_) => "a list of 3 of `true` or `false`",
        Wants::Nothing => "nothing",
    };
    types.add_type(pointer, node, wanted);
}

/// Whether Blender takes it for a switch.
pub(super) fn is_bool(node: &Node) -> bool {
    match node.value {
        Value::Bool(_) => true,
        Value::Number(_, true) => matches!(node.as_i64(), Some(0 | 1)),
        _ => false,
    }
}

/// Three numbers.
pub(super) fn triple(node: &Node) -> Option<[f64; 3]> {
    match node.elements() {
        [x, y, z] => Some([
            x.as_python_number()?,
            y.as_python_number()?,
            z.as_python_number()?,
        ]),
        _ => None,
    }
}

fn is_list(node: &Node, count: usize, is_one: impl Fn(&Node) -> bool) -> bool {
    node.elements().len() == count && node.is_array() && node.elements().iter().all(is_one)
}
