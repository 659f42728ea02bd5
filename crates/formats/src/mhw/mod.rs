//! `.mhw`: weights of bones on vertices (`docs/loaders/makehuman2/weights.md#weights-file`).
//!
//! Read through the pull reader, pair by pair, without a tree: the files are large. Faults of
//! single pairs are counted; a shape that is no weights file at all is left to the schema.

pub mod edit;
mod facts;
mod sums;

use std::collections::{BTreeMap, BTreeSet};

use crate::faulty_rows::text_name;
use crate::json_file::JsonFault;
pub use crate::mhw::facts::{FAR_SUMS, PairTally, SumFacts, THRESHOLD, WeightsFacts};
use mhlint_diag::Few;
use mhlint_json::{Reader, SyntaxFault};
use mhlint_source::Encoding;

/// The file.
#[derive(Debug, Clone, Default)]
pub struct Weights {
    /// Bones in file order; of equal names the last.
    pub bones: Vec<BoneWeights>,
    /// Keys of the top level, as far as they are metadata.
    pub metadata: Vec<String>,
    /// Whether `weights` is an object.
    pub has_weights: bool,
    /// Whether the value of some bone is no list, which the loader cannot walk.
    pub has_shapeless_bone: bool,
    /// What was counted.
    pub facts: WeightsFacts,
}

/// Weights of a bone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BoneWeights {
    /// Name of the bone.
    pub name: String,
    /// Well-formed pairs in file order: position in the list, vertex, weight.
    pub pairs: Vec<Pair>,
    /// Whether its value is a list.
    pub is_list: bool,
    /// Length of the list, malformed pairs included.
    pub listed: usize,
    /// Positions of the first pairs that are not `[integer, number]`.
    pub malformed: Vec<u32>,
}

/// A vertex and its weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Position in the bone's list.
    pub position: u32,
    /// Vertex as written.
    pub vertex: i64,
    /// Weight.
    pub weight: f32,
}

/// Parses a weights file. `vertices` is the vertex count of the mesh it is for, without seam
/// duplicates.
///
/// # Errors
/// The fault that keeps the loader from reading the text at all.
pub fn parse(
    text: &[u8],
    encoding: &Encoding,
    vertices: Option<usize>,
) -> Result<Weights, JsonFault> {
    if encoding.blank
        || encoding.byte_order_mark
        || encoding.lfs_pointer
        || encoding.invalid_utf8_at.is_some()
    {
        // The common reader names these faults; it never gets as far as the text.
        super::json_file::parse(text, encoding)?;
    }
    let mut reader = Reader::new(text);
    let mut weights = Weights::default();
    read_file(&mut reader, &mut weights).map_err(JsonFault::Syntax)?;
    keep_last_of_equal_bones(&mut weights);
    weights.facts.count(&weights.bones, vertices);
    Ok(weights)
}

type Step<T> = Result<T, SyntaxFault>;

fn read_file(reader: &mut Reader<'_>, weights: &mut Weights) -> Step<()> {
    if reader.peek() != Some(b'{') {
        reader.pass()?;
        return reader.finish();
    }
    reader.open()?;
    let mut keys = BTreeSet::new();
    while reader.more(b'}')? {
        let (key, _) = reader.key()?;
        weights.facts.has_duplicate_keys |= !keys.insert(key.clone());
        if key == "weights" {
            weights.bones.clear();
            weights.has_shapeless_bone = false;
            weights.has_weights = reader.peek() == Some(b'{');
            if weights.has_weights {
                read_bones(reader, weights)?;
            } else {
                reader.pass()?;
            }
        } else {
            weights.metadata.push(key.into_owned());
            reader.pass()?;
        }
    }
    reader.finish()
}

fn read_bones(reader: &mut Reader<'_>, weights: &mut Weights) -> Step<()> {
    reader.open()?;
    while reader.more(b'}')? {
        let (name, _) = reader.key()?;
        let mut bone = BoneWeights {
            name: name.into_owned(),
            ..BoneWeights::default()
        };
        if reader.peek() == Some(b'[') {
            bone.is_list = true;
            read_pairs(reader, &mut bone, &mut weights.facts.malformed_names)?;
        } else {
            weights.has_shapeless_bone = true;
            reader.pass()?;
        }
        weights.bones.push(bone);
    }
    Ok(())
}

fn read_pairs(
    reader: &mut Reader<'_>,
    bone: &mut BoneWeights,
    malformed: &mut Few<String>,
) -> Step<()> {
    reader.open()?;
    while reader.more(b']')? {
        let position = u32::try_from(bone.listed).unwrap_or(u32::MAX);
        bone.listed += 1;
        let start = reader.offset();
        if let Some((vertex, weight)) = read_pair(reader)? {
            bone.pairs.push(Pair {
                position,
                vertex,
                weight,
            });
            continue;
        }
        let text = reader.since(start);
        malformed.add_long(bone.name.len(), || entry_name(&bone.name, text));
        if bone.malformed.len() < mhlint_diag::EXAMPLES {
            bone.malformed.push(position);
        }
    }
    Ok(())
}

/// Layout is not part of a name.
fn entry_name(bone: &str, text: &[u8]) -> String {
    let compact: Vec<u8> = text
        .iter()
        .copied()
        .filter(|byte| !byte.is_ascii_whitespace())
        .collect();
    format!("{bone} {}", text_name(&compact))
}

/// `[integer, number]`, `true` and `false` counting as 1 and 0; nothing for any other value.
fn read_pair(reader: &mut Reader<'_>) -> Step<Option<(i64, f32)>> {
    if reader.peek() != Some(b'[') {
        reader.pass()?;
        return Ok(None);
    }
    reader.open()?;
    let mut numbers = [None; 2];
    let mut length = 0;
    while reader.more(b']')? {
        let number = if matches!(reader.peek(), Some(b'-' | b'0'..=b'9' | b'N' | b'I')) {
            reader.number()?
        } else if length == 1 && reader.literal("true") {
            // NumPy makes numbers of them, as long as they are weights.
            Some((1.0, false))
        } else if length == 1 && reader.literal("false") {
            Some((0.0, false))
        } else {
            reader.pass()?;
            None
        };
        if let Some(slot) = numbers.get_mut(length) {
            *slot = number;
        }
        length += 1;
    }
    #[expect(
        clippy::cast_possible_truncation,
        reason = "indices beyond 2^53 are out of range anyway; weights are float32"
    )]
    match (length, numbers) {
        (2, [Some((vertex, true)), Some((weight, _))]) => Ok(Some((vertex as i64, weight as f32))),
        _ => Ok(None),
    }
}

/// Python's reader keeps the last of equal keys; the schema reader reports them.
fn keep_last_of_equal_bones(weights: &mut Weights) {
    let mut last = BTreeMap::new();
    for (index, bone) in weights.bones.iter().enumerate() {
        last.insert(bone.name.clone(), index);
    }
    if last.len() < weights.bones.len() {
        weights.facts.has_duplicate_keys = true;
        let mut index = 0;
        weights.bones.retain(|bone| {
            index += 1;
            last.get(&bone.name) == Some(&(index - 1))
        });
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn weights(text: &str) -> Weights {
        parse(text.as_bytes(), &Encoding::of(text.as_bytes()), Some(4)).unwrap()
    }

    #[test]
    fn the_last_of_equal_bones_wins() {
        let weights = weights(r#"{"weights": {"a": [[0, 1], 7], "b": [], "a": [[1, 1]]}}"#);
        let names: Vec<_> = weights
            .bones
            .iter()
            .map(|bone| bone.name.as_str())
            .collect();
        assert_eq!(names, ["b", "a"]);
        assert_eq!(weights.bones[1].pairs[0].vertex, 1);
        assert_eq!(
            (
                weights.facts.has_duplicate_keys,
                weights.facts.malformed.count
            ),
            (true, 0)
        );
    }

    #[test]
    fn other_shapes_are_no_weights() {
        assert!(!weights(r#"{"weights": [1, {"a": [[]]}]}"#).has_weights);
        assert!(!weights("[]").has_weights);
        assert!(weights(r#"{"weights": {"a": null}}"#).has_shapeless_bone);
        assert!(parse(b"{\"weights\": {", &Encoding::default(), None).is_err());
    }

    #[test]
    fn metadata_and_empty_lists_are_kept() {
        let weights = weights(r#"{"name": "x", "weights": {"a": []}, "license": "CC0"}"#);
        assert_eq!(weights.metadata, ["name", "license"]);
        assert_eq!((weights.bones[0].listed, weights.has_weights), (0, true));
    }

    proptest! {
        #[test]
        fn any_bytes_give_a_result(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            let _ = parse(&bytes, &Encoding::of(&bytes), Some(3));
        }

        #[test]
        fn any_pair_is_counted_once(
            index in any::<i64>(), weight in "-?[0-9]{1,40}(\\.[0-9]{1,5})?(e[0-9]{1,4})?|NaN|-Infinity", mesh in 0usize..5,
        ) {
            let text = format!("{{\"weights\": {{\"a\": [[{index}, {weight}]]}}}}");
            if let Ok(weights) = parse(text.as_bytes(), &Encoding::of(text.as_bytes()), Some(mesh)) {
                prop_assert_eq!((weights.facts.pairs, weights.facts.vertices), (1, mesh));
            }
        }

        #[test]
        fn a_truncated_file_is_a_fault(cut in 1usize..70) {
            let text = r#"{"name": "x", "weights": {"a": [[0, 0.5], [1, 1]], "b": [[0, 0.5]]}}"#;
            let part = &text.as_bytes()[..cut.min(text.len() - 1)];
            prop_assert!(parse(part, &Encoding::of(part), None).is_err());
        }
    }
}
