//! Layers of old rigs, and what became of them
//! (`docs/loaders/mpfb/rigs.md#layers-below-version-110`).

use crate::unfit::below;
use mhlint_json::Node;

/// Layers that Blender had.
const COUNT: usize = 32;

/// What is wrong with layers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LayersFault {
    /// One that does not exist is set: pointer, and its number.
    Beyond(String, usize),
    /// So many entries instead of 32: pointer, and their number.
    Length(String, usize),
    /// Nothing reads them: pointer, and whether they are those that every bone is on.
    Dead(String, bool),
}

/// Keys of Rigify that were lists of layers.
pub(super) const OF_RIGIFY: [&str; 3] = ["fk_layers", "tweak_layers", "secondary_layers"];

/// What is wrong with the layers of a bone.
pub(super) fn check(pointer: &str, bone: &Node, are_read: bool, faults: &mut Vec<LayersFault>) {
    let Some(layers) = bone.get("layers") else {
        return;
    };
    let pointer = below(pointer, "layers");
    let set = layers
        .elements()
        .iter()
        .enumerate()
        .filter(|(_, layer)| !layer.is_falsy())
        .map(|(at, _)| at);
    let set: Vec<usize> = set.collect();
    if !are_read {
        faults.push(LayersFault::Dead(
            pointer,
            matches!(set.as_slice(), [] | [0]),
        ));
    } else if let Some(beyond) = set.iter().find(|at| **at >= COUNT) {
        faults.push(LayersFault::Beyond(pointer, *beyond));
    } else if layers.is_array() && layers.elements().len() != COUNT {
        faults.push(LayersFault::Length(pointer, layers.elements().len()));
    }
}

/// What is wrong with those of Rigify.
pub(super) fn check_rigify(
    pointer: &str,
    parameters: &Node,
    are_read: bool,
    faults: &mut Vec<LayersFault>,
) {
    for key in OF_RIGIFY
        .iter()
        .filter(|key| parameters.get(key).is_some() && !are_read)
    {
        faults.push(LayersFault::Dead(below(pointer, key), false));
    }
}
