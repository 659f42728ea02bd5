//! `.mhw`: weights of bones on vertices (formats/makehuman2.md §11).
//!
//! Read through the pull reader, pair by pair, without a tree: the files are large. Faults of single
//! pairs are counted; a shape that is no weights file at all is left to the schema.

use std::collections::BTreeMap;

use serde::Serialize;

use super::json_file::JsonFault;
use crate::diag::Evidence;
use crate::json::{Duplicate, Reader, SyntaxFault};
use crate::source::Encoding;

/// Entries whose normalised weight is not above this are dropped by the loaders.
pub const THRESHOLD: f32 = 1e-4;

/// The file.
#[derive(Debug, Clone, Default)]
pub struct Weights {
    /// Bones in file order; of equal names the last.
    pub bones: Vec<BoneWeights>,
    /// Keys of the top level, as far as they are metadata.
    pub metadata: Vec<String>,
    /// Whether `weights` is an object.
    pub has_weights: bool,
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
    /// Length of the list, malformed pairs included.
    pub listed: usize,
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

/// Facts on a weights file.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct WeightsFacts {
    /// Well-formed pairs.
    pub pairs: usize,
    /// Pairs that are not `[integer, number]`.
    pub malformed: PairTally,
    /// Weights below 0.
    pub negative: PairTally,
    /// Weights above 1.
    pub above_one: PairTally,
    /// NaN and infinity.
    pub non_finite: PairTally,
    /// Pairs that normalising leaves at or below [`THRESHOLD`], zero weights included.
    pub below_threshold: PairTally,
    /// A vertex that the bone listed before.
    pub duplicate: PairTally,
    /// Vertices that the mesh does not have, negative ones included.
    pub out_of_range: PairTally,
    /// Sum over all bones per vertex of the mesh, float32 as in the loader. Empty without a mesh.
    #[serde(skip)]
    pub sums: Vec<f32>,
    /// Duplicate keys and other facts on the text.
    pub json: super::json_file::JsonFacts,
}

/// Counts pairs: how many, the first few as bone and position.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct PairTally {
    /// How many.
    pub count: u64,
    /// The first few: bone, position in its list, vertex, weight.
    pub first: Vec<(String, u32, i64, f32)>,
    /// The number farthest from what is allowed, where that makes sense.
    pub worst: Option<(String, i64, f32)>,
}

impl PairTally {
    fn add(&mut self, bone: &str, pair: Pair) {
        self.count += 1;
        if self.first.len() < crate::diag::EXAMPLES {
            self.first.push((bone.to_owned(), pair.position, pair.vertex, pair.weight));
        }
        let farther = |worst: &(String, i64, f32)| pair.weight.abs() > worst.2.abs();
        if self.worst.as_ref().is_none_or(farther) {
            self.worst = Some((bone.to_owned(), pair.vertex, pair.weight));
        }
    }

    /// As evidence: vertices with their bones as examples.
    pub fn evidence(&self, total: usize) -> Evidence {
        let examples = self.first.iter();
        Evidence {
            count: self.count,
            of: Some(total as u64),
            examples: examples.map(|(bone, _, vertex, _)| format!("{bone}[{vertex}]")).collect(),
            worst: None,
        }
    }
}

/// Parses a weights file. `vertices` is the vertex count of the mesh it is for, without seam duplicates.
///
/// # Errors
/// The fault that keeps the loader from reading the text at all.
pub fn parse(text: &[u8], encoding: &Encoding, vertices: Option<usize>) -> Result<Weights, JsonFault> {
    if encoding.blank || encoding.byte_order_mark || encoding.lfs_pointer || encoding.invalid_utf8_at.is_some() {
        // The common reader names these faults; it never gets as far as the text.
        super::json_file::parse(text, encoding)?;
    }
    let mut reader = Reader::new(text);
    let mut weights = Weights::default();
    read_file(&mut reader, &mut weights).map_err(JsonFault::Syntax)?;
    weights.facts.json.specials = std::mem::take(&mut reader.specials);
    keep_last_of_equal_bones(&mut weights);
    count(&mut weights, vertices);
    Ok(weights)
}

type Step<T> = Result<T, SyntaxFault>;

fn read_file(reader: &mut Reader<'_>, weights: &mut Weights) -> Step<()> {
    if reader.peek() != Some(b'{') {
        skip(reader)?;
        return reader.finish();
    }
    reader.open()?;
    let mut first = true;
    while reader.more(first, b'}')? {
        first = false;
        let (key, _) = reader.key()?;
        if key == "weights" {
            weights.bones.clear();
            weights.has_weights = reader.peek() == Some(b'{');
            if weights.has_weights {
                read_bones(reader, weights)?;
            } else {
                skip(reader)?;
            }
        } else {
            weights.metadata.push(key.into_owned());
            skip(reader)?;
        }
    }
    reader.finish()
}

fn read_bones(reader: &mut Reader<'_>, weights: &mut Weights) -> Step<()> {
    reader.open()?;
    let mut first = true;
    while reader.more(first, b'}')? {
        first = false;
        let (name, _) = reader.key()?;
        let mut bone = BoneWeights { name: name.into_owned(), ..BoneWeights::default() };
        if reader.peek() == Some(b'[') {
            read_pairs(reader, &mut bone, &mut weights.facts)?;
        } else {
            skip(reader)?;
        }
        weights.bones.push(bone);
    }
    Ok(())
}

fn read_pairs(reader: &mut Reader<'_>, bone: &mut BoneWeights, facts: &mut WeightsFacts) -> Step<()> {
    reader.open()?;
    while reader.more(bone.listed == 0, b']')? {
        let position = u32::try_from(bone.listed).unwrap_or(u32::MAX);
        bone.listed += 1;
        if let Some((vertex, weight)) = read_pair(reader)? {
            bone.pairs.push(Pair { position, vertex, weight });
        } else {
            let nothing = Pair { position, vertex: -1, weight: 0.0 };
            facts.malformed.add(&bone.name, nothing);
        }
    }
    Ok(())
}

/// `[integer, number]`, or nothing for any other value.
fn read_pair(reader: &mut Reader<'_>) -> Step<Option<(i64, f32)>> {
    if reader.peek() != Some(b'[') {
        skip(reader)?;
        return Ok(None);
    }
    reader.open()?;
    let mut numbers = [None; 2];
    let mut length = 0;
    while reader.more(length == 0, b']')? {
        let number = if matches!(reader.peek(), Some(b'-' | b'0'..=b'9' | b'N' | b'I')) {
            reader.number()?
        } else {
            skip(reader)?;
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

fn skip(reader: &mut Reader<'_>) -> Step<()> {
    match reader.peek() {
        Some(b'{') => {
            reader.open()?;
            let mut first = true;
            while reader.more(first, b'}')? {
                first = false;
                reader.key()?;
                skip(reader)?;
            }
            Ok(())
        }
        Some(b'[') => {
            reader.open()?;
            let mut first = true;
            while reader.more(first, b']')? {
                first = false;
                skip(reader)?;
            }
            Ok(())
        }
        Some(b'"') => reader.string().map(|_| ()),
        _ => {
            let known = reader.number()?.is_some() || ["null", "true", "false"].iter().any(|word| reader.literal(word));
            if known { Ok(()) } else { Err(reader.expected("a value")) }
        }
    }
}

/// Python's reader keeps the last of equal keys; the schema reader reports them.
fn keep_last_of_equal_bones(weights: &mut Weights) {
    let mut last = BTreeMap::new();
    for (index, bone) in weights.bones.iter().enumerate() {
        if let Some(lost) = last.insert(bone.name.clone(), index) {
            let pointer = format!("/weights/{}", bone.name.replace('~', "~0").replace('/', "~1"));
            let duplicate = Duplicate { pointer, lost: lost..lost, kept: index..index, equal: false };
            weights.facts.json.duplicates.push(duplicate);
        }
    }
    if last.len() < weights.bones.len() {
        let mut index = 0;
        weights.bones.retain(|bone| {
            index += 1;
            last.get(&bone.name) == Some(&(index - 1))
        });
    }
}

fn count(weights: &mut Weights, vertices: Option<usize>) {
    let Weights { bones, facts, .. } = weights;
    facts.sums = vec![0.0; vertices.unwrap_or(0)];
    for bone in bones.iter() {
        facts.pairs += bone.pairs.len();
        for pair in &bone.pairs {
            count_pair(facts, &bone.name, *pair, vertices);
        }
        count_duplicates(facts, bone);
    }
    if vertices.is_some() {
        for bone in bones.iter() {
            count_below_threshold(facts, bone);
        }
    }
}

fn count_pair(facts: &mut WeightsFacts, bone: &str, pair: Pair, vertices: Option<usize>) {
    if !pair.weight.is_finite() {
        facts.non_finite.add(bone, pair);
    } else if pair.weight < 0.0 {
        facts.negative.add(bone, pair);
    } else if pair.weight > 1.0 {
        facts.above_one.add(bone, pair);
    }
    let slot = usize::try_from(pair.vertex).ok().and_then(|vertex| facts.sums.get_mut(vertex));
    match slot {
        Some(sum) => *sum += pair.weight,
        None if vertices.is_some() || pair.vertex < 0 => facts.out_of_range.add(bone, pair),
        None => {}
    }
}

/// Shipped lists are sorted, which needs no table.
fn count_duplicates(facts: &mut WeightsFacts, bone: &BoneWeights) {
    if bone.pairs.is_sorted_by(|a, b| a.vertex < b.vertex) {
        return;
    }
    let mut seen = std::collections::BTreeSet::new();
    for pair in &bone.pairs {
        if !seen.insert(pair.vertex) {
            facts.duplicate.add(&bone.name, *pair);
        }
    }
}

fn count_below_threshold(facts: &mut WeightsFacts, bone: &BoneWeights) {
    for pair in &bone.pairs {
        let sum = usize::try_from(pair.vertex).ok().and_then(|vertex| facts.sums.get(vertex).copied());
        if let Some(sum) = sum
            && sum > 0.0
            && pair.weight >= 0.0
            && pair.weight / sum <= THRESHOLD
        {
            facts.below_threshold.add(&bone.name, *pair);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(text: &str) -> Weights {
        parse(text.as_bytes(), &Encoding::of(text.as_bytes()), Some(4)).unwrap()
    }

    #[test]
    fn pairs_are_sorted_into_their_faults() {
        let text = r#"{"name": "x", "weights": {"a": [[0, 0.5], [0, 0.5], [1, -0.25], [2, 1.5], [4, 1], [-1, 1]],
            "b": [[1, 1], [3, NaN], [2, 0.0001], 7, [1], ["1", 1], [1.0, 1]], "c": []}}"#;
        let weights = weights(text);
        let f = &weights.facts;
        let counts = [&f.duplicate, &f.negative, &f.above_one, &f.out_of_range, &f.non_finite, &f.malformed];
        assert_eq!(counts.map(|tally| tally.count), [1, 1, 1, 2, 1, 4]);
        assert_eq!(f.below_threshold.first, [("b".to_owned(), 2, 2, 0.0001)]);
        assert_eq!((f.sums[0], f.sums[1]), (1.0, 0.75));
        assert_eq!((weights.bones[2].listed, weights.metadata.as_slice()), (0, ["name".to_owned()].as_slice()));
    }

    #[test]
    fn the_last_of_equal_bones_wins() {
        let weights = weights(r#"{"weights": {"a": [[0, 1]], "b": [], "a": [[1, 1]]}}"#);
        let names: Vec<_> = weights.bones.iter().map(|bone| bone.name.as_str()).collect();
        assert_eq!(names, ["b", "a"]);
        assert_eq!(weights.bones[1].pairs[0].vertex, 1);
        assert_eq!(weights.facts.json.duplicates.len(), 1);
    }

    #[test]
    fn other_shapes_are_no_weights() {
        assert!(!weights(r#"{"weights": [1, {"a": [[]]}]}"#).has_weights);
        assert!(!weights("[]").has_weights);
        assert!(parse(b"{\"weights\": {", &Encoding::default(), None).is_err());
    }
}
