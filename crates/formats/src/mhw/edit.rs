//! Weights rewritten in the text of a `.mhw`: entries taken out, merged, normalised.
//!
//! Sums are formed as the loader forms them, float32 in the order of the file
//! (`docs/loaders/makehuman2/weights.md#loading-weights`), so that a normalised vertex loads to the
//! very numbers it had before. Vertices that need nothing keep their bytes.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::mhw::facts::{SUM_TOLERANCE, THRESHOLD};
use crate::stored;
use mhlint_diag::{Edit, Grouped, grouped};
use mhlint_json::{self as json, Member, Node};

/// Steps in which the rounding of a sum is given to the largest weight; one is nearly always
/// enough.
const ROUNDING_STEPS: usize = 8;
/// Digits behind a point that are copied; the smallest float32 that counts has not as many.
const MOST_DECIMALS: usize = 40;

/// The pairs of a file.
struct Table<'d> {
    /// The object of bones.
    object: &'d Node,
    /// All members; of equal bones only the last is read.
    bones: &'d [Member],
    /// Well-formed pairs in file order.
    entries: Vec<Entry>,
}

/// A vertex and its weight in a bone.
struct Entry {
    /// Position of the bone among all members.
    bone: usize,
    /// Position in its list.
    at: usize,
    vertex: i64,
    weight: f64,
    /// Bytes of the weight.
    number: Range<usize>,
}

impl Entry {
    fn loaded(&self) -> f32 {
        stored(self.weight)
    }
}

/// Divides the weights of every vertex by their sum where that is not 1, as the loader does.
pub fn normalize_weights(text: &[u8]) -> Vec<Edit> {
    edit(text, |table| {
        let mut edits = Vec::new();
        for entries in table
            .by_vertex()
            .into_values()
            .filter(|entries| !is_faulty(entries))
        {
            let weights: Vec<f32> = entries.iter().map(|entry| entry.loaded()).collect();
            if let Some(divided) = normalized(&weights).filter(|_| is_off(&weights)) {
                let written = entries.iter().zip(divided);
                edits.extend(written.map(|(entry, weight)| entry.written(text, weight)));
            }
        }
        edits
    })
}

/// Takes out entries that the loader drops, and bones that nothing is left of.
pub fn drop_small_weights(text: &[u8]) -> Vec<Edit> {
    edit(text, |table| {
        let sums: BTreeMap<i64, f32> = table
            .by_vertex()
            .into_iter()
            .map(|(vertex, entries)| (vertex, sum(entries.iter().map(|e| e.loaded()))))
            .collect();
        let is_small = |entry: &&Entry| {
            let sum = sums.get(&entry.vertex).copied().unwrap_or(0.0);
            // Of a sum beyond float32 every share is 0, however large the weight.
            sum > 0.0 && sum.is_finite() && entry.weight >= 0.0 && entry.loaded() / sum <= THRESHOLD
        };
        table.without(
            text,
            &table
                .entries
                .iter()
                .filter(is_small)
                .map(|entry| (entry.bone, entry.at))
                .collect(),
        )
    })
}

/// Replaces entries of one vertex in one bone by one with their sum; the vertex is normalised where
/// that is needed.
pub fn merge_weights(text: &[u8]) -> Vec<Edit> {
    edit(text, |table| {
        let mut edits = Vec::new();
        let mut gone = BTreeSet::new();
        for entries in table
            .by_vertex()
            .into_values()
            .filter(|entries| repeats(entries))
        {
            let merged = merged(&entries);
            // No JSON can say a weight beyond float32; the vertex is left to the rule on such
            // weights.
            if !is_finite(&merged) {
                continue;
            }
            let kept: BTreeSet<(usize, usize)> = merged
                .iter()
                .map(|(first, ..)| (first.bone, first.at))
                .collect();
            gone.extend(
                entries
                    .iter()
                    .map(|entry| (entry.bone, entry.at))
                    .filter(|place| !kept.contains(place)),
            );
            let weights: Vec<f32> = merged
                .iter()
                .map(|(_, weight, _)| stored(*weight))
                .collect();
            // A weight that was too large before it was merged has a rule of its own, and stays for
            // it.
            let was_too_large = entries
                .iter()
                .any(|entry| entry.loaded() > 1.0 + SUM_TOLERANCE);
            let needs_division = is_off(&weights) || weights.iter().any(|weight| *weight > 1.0);
            if let Some(divided) = normalized(&weights).filter(|_| !was_too_large && needs_division)
            {
                let written = merged.iter().zip(divided);
                edits.extend(written.map(|((entry, ..), weight)| entry.written(text, weight)));
            } else {
                let repeated = merged
                    .iter()
                    .zip(&weights)
                    .filter(|((_, _, parts), _)| parts.len() > 1);
                edits.extend(repeated.map(|((entry, weight, parts), loaded)| {
                    let decimals: Option<Vec<usize>> = parts
                        .iter()
                        .map(|part| decimals(part.token(text)))
                        .collect();
                    match decimals.and_then(|decimals| decimals.into_iter().max()) {
                        Some(decimals) => {
                            Edit::replacement(entry.number.clone(), format!("{weight:.decimals$}"))
                        }
                        None => entry.written(text, *loaded),
                    }
                }));
            }
        }
        edits.extend(table.without(text, &gone));
        edits
    })
}

fn edit(text: &[u8], edits: impl FnOnce(&Table<'_>) -> Vec<Edit>) -> Vec<Edit> {
    let Ok(document) = json::parse(text) else {
        return Vec::new();
    };
    let Some(object) = document.root.get("weights") else {
        return Vec::new();
    };
    edits(&Table::new(object))
}

impl<'d> Table<'d> {
    fn new(object: &'d Node) -> Self {
        let bones = object.members();
        let last: BTreeMap<&str, usize> = bones
            .iter()
            .enumerate()
            .map(|(at, bone)| (bone.key.as_str(), at))
            .collect();
        let read = bones
            .iter()
            .enumerate()
            .filter(|(at, bone)| last.get(bone.key.as_str()) == Some(at));
        let pairs = |(bone, member): (usize, &'d Member)| {
            let elements = member.node.elements().iter().enumerate();
            elements.filter_map(move |(at, pair)| Entry::read(bone, at, pair))
        };
        Self {
            object,
            bones,
            entries: read.flat_map(pairs).collect(),
        }
    }

    fn by_vertex(&self) -> Grouped<i64, &Entry> {
        grouped(self.entries.iter().map(|entry| (entry.vertex, entry)))
    }

    /// The file without some pairs; a bone that they empty goes as a whole, for an empty list says
    /// nothing.
    fn without(&self, text: &[u8], gone: &BTreeSet<(usize, usize)>) -> Vec<Edit> {
        let is_emptied = |bone: usize| {
            let listed = self
                .bones
                .get(bone)
                .map_or(0, |member| member.node.elements().len());
            listed > 0 && gone.range((bone, 0)..=(bone, usize::MAX)).count() == listed
        };
        let members = |bone: usize| {
            self.bones
                .get(bone)
                .map(|member| member.key_span.start..member.node.span.end)
        };
        let emptied = (0..self.bones.len())
            .filter(|bone| is_emptied(*bone))
            .collect();
        let mut edits = json::removals(text, self.object, (self.bones.len(), &members), &emptied);
        for (bone, member) in self
            .bones
            .iter()
            .enumerate()
            .filter(|(bone, _)| !is_emptied(*bone))
        {
            let gone = gone
                .range((bone, 0)..=(bone, usize::MAX))
                .map(|(_, at)| *at)
                .collect();
            let pairs = |at: usize| member.node.elements().get(at).map(|pair| pair.span.clone());
            edits.extend(json::removals(
                text,
                &member.node,
                (member.node.elements().len(), &pairs),
                &gone,
            ));
        }
        edits
    }
}

impl Entry {
    fn read(bone: usize, at: usize, pair: &Node) -> Option<Self> {
        let [vertex, weight] = pair.elements() else {
            return None;
        };
        let number = weight.span.clone();
        Some(Self {
            bone,
            at,
            vertex: vertex.as_i64()?,
            weight: weight.as_python_number()?,
            number,
        })
    }

    fn token<'t>(&self, text: &'t [u8]) -> &'t [u8] {
        text.get(self.number.clone()).unwrap_or_default()
    }

    /// The weight as the shortest decimal that loads to this very number; with a point where there
    /// was one.
    fn written(&self, text: &[u8], weight: f32) -> Edit {
        let mut written = weight.to_string();
        if self.token(text).contains(&b'.') && !written.contains('.') {
            written.push_str(".0");
        }
        Edit::replacement(self.number.clone(), written)
    }
}

/// Digits behind the point; a number with an exponent does not tell, nor one with more than anybody
/// writes.
fn decimals(token: &[u8]) -> Option<usize> {
    if token.iter().any(|byte| matches!(byte, b'e' | b'E')) {
        return None;
    }
    let decimals = token
        .iter()
        .position(|byte| *byte == b'.')
        .map_or(0, |point| token.len() - point - 1);
    (decimals <= MOST_DECIMALS).then_some(decimals)
}

fn sum(weights: impl IntoIterator<Item = f32>) -> f32 {
    weights.into_iter().fold(0.0, |sum, weight| sum + weight)
}

fn is_off(weights: &[f32]) -> bool {
    let sum = sum(weights.iter().copied());
    sum != 0.0 && (sum - 1.0).abs() > SUM_TOLERANCE
}

/// Entries that have a rule of their own; the vertex is left to it.
fn is_faulty(entries: &[&Entry]) -> bool {
    repeats(entries)
        || entries
            .iter()
            .any(|entry| !(0.0..=1.0 + SUM_TOLERANCE).contains(&entry.loaded()))
}

/// Whether a bone lists the vertex of these entries twice.
fn repeats(entries: &[&Entry]) -> bool {
    entries
        .windows(2)
        .any(|pair| matches!(pair, [a, b] if a.bone == b.bone))
}

/// For each bone the first entry, the sum of all, and all of them.
fn merged<'e, 'd>(entries: &'e [&'d Entry]) -> Vec<(&'d Entry, f64, &'e [&'d Entry])> {
    let bones = entries.chunk_by(|a, b| a.bone == b.bone);
    bones
        .filter_map(|parts| {
            Some((
                *parts.first()?,
                parts.iter().map(|entry| entry.weight).sum(),
                parts,
            ))
        })
        .collect()
}

/// Whether the weights and all sums of them are numbers of float32.
fn is_finite(merged: &[(&Entry, f64, &[&Entry])]) -> bool {
    let all = merged.iter().flat_map(|(_, _, parts)| parts.iter());
    all.map(|entry| entry.loaded().abs())
        .sum::<f32>()
        .is_finite()
}

/// The weights divided by their sum, which is 1 afterwards: what rounding leaves goes to the
/// largest. Nothing where the sum is none that can be divided by.
fn normalized(weights: &[f32]) -> Option<Vec<f32>> {
    let total = sum(weights.iter().copied());
    let mut divided: Vec<f32> = weights.iter().map(|weight| weight / total).collect();
    for _ in 0..ROUNDING_STEPS {
        let left = 1.0 - sum(divided.iter().copied());
        let Some(largest) = divided
            .iter_mut()
            .max_by(|a, b| a.total_cmp(b))
            .filter(|_| left != 0.0)
        else {
            break;
        };
        *largest += left;
    }
    divided
        .iter()
        .all(|weight| weight.is_finite())
        .then_some(divided)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::mhw::sums::Sums;
    use crate::mhw::{Weights, parse};
    use mhlint_source::Encoding;

    fn edited(text: &str, mut edits: Vec<Edit>) -> String {
        edits.sort_by_key(|edit| std::cmp::Reverse(edit.range.start));
        let mut bytes = text.as_bytes().to_vec();
        edits
            .into_iter()
            .for_each(|edit| drop(bytes.splice(edit.range, edit.text)));
        String::from_utf8(bytes).unwrap()
    }

    fn by(operation: fn(&[u8]) -> Vec<Edit>, text: &str) -> String {
        edited(text, operation(text.as_bytes()))
    }

    fn read(text: &str) -> Weights {
        parse(text.as_bytes(), &Encoding::of(text.as_bytes()), Some(6)).unwrap()
    }

    #[test]
    fn only_vertices_that_are_off_are_written() {
        let text = "{\"weights\": {\n\t\"a\": [[0, 0.250], [1, 0.25],\n\t\t[2, 2], [3, \
            1e-1]],\n\t\"b\": [[1,0.5], [0, 0.75]]}}";
        let expected = "{\"weights\": {\n\t\"a\": [[0, 0.250], [1, 0.33333334],\n\t\t[2, 2], [3, \
            1]],\n\t\"b\": [[1,0.6666667], [0, 0.75]]}}";
        assert_eq!(by(normalize_weights, text), expected);
        assert_eq!(by(normalize_weights, expected), expected);
    }

    #[test]
    fn small_entries_go_and_emptied_bones_with_them() {
        let text = "{\"weights\": {\n  \"a\": [[0, 0.5], [1, 0.0],\n    [2, 1]],\n  \"b\": [[1, \
            0.0001]],\n  \"c\": [[0, 0.5], [1, 1]]}}";
        let expected =
            "{\"weights\": {\n  \"a\": [[0, 0.5],\n    [2, 1]],\n  \"c\": [[0, 0.5], [1, 1]]}}";
        assert_eq!(by(drop_small_weights, text), expected);
    }

    #[test]
    fn repeated_entries_become_their_sum_in_the_style_of_the_file() {
        let text = r#"{"weights": {"a": [[0, 0.5], [1, 0.25], [0, 0.50], [1, 0.125]], "b": [[1, 0.625]]}}"#;
        let expected = r#"{"weights": {"a": [[0, 1.00], [1, 0.375]], "b": [[1, 0.625]]}}"#;
        assert_eq!(by(merge_weights, text), expected);
        let exponent = r#"{"weights": {"a": [[0, 0.5], [0, 2.5e-1], [0, 0.25]]}}"#;
        assert_eq!(
            by(merge_weights, exponent),
            r#"{"weights": {"a": [[0, 1.0]]}}"#
        );
        let beyond = r#"{"weights": {"a": [[0, 0.75], [0, 0.75]], "b": [[0, 0.5]]}}"#;
        assert_eq!(
            by(merge_weights, beyond),
            r#"{"weights": {"a": [[0, 0.75]], "b": [[0, 0.25]]}}"#
        );
        let too_large = r#"{"weights": {"a": [[0, 0.5], [0, 1.5]], "b": [[0, 0.5]]}}"#;
        assert_eq!(
            by(merge_weights, too_large),
            r#"{"weights": {"a": [[0, 2.0]], "b": [[0, 0.5]]}}"#
        );
        let endless = format!(
            r#"{{"weights": {{"a": [[0, 0.5{}], [0, 0.5]]}}}}"#,
            "0".repeat(70_000)
        );
        assert_eq!(
            by(merge_weights, &endless),
            r#"{"weights": {"a": [[0, 1.0]]}}"#
        );
    }

    #[test]
    fn weights_beyond_float32_stay() {
        for text in [
            r#"{"weights": {"a": [[5, 1], [5, 1e40]]}}"#,
            r#"{"weights": {"a": [[5, 3e38], [5, 3e38]]}}"#,
            r#"{"weights": {"a": [[5, 3e38], [5, 0]], "b": [[5, -3e38]]}}"#,
            r#"{"weights": {"a": [[5, -1e40], [5, 1]], "b": [[5, 0.5]]}}"#,
            r#"{"weights": {"a": [[5, NaN], [5, 1]]}}"#,
        ] {
            for operation in [merge_weights, drop_small_weights, normalize_weights] {
                assert_eq!(by(operation, text), text);
            }
        }
        let cancelled = r#"{"weights": {"a": [[5, 0.75], [5, 0.75]], "b": [[5, -1.5]]}}"#;
        assert_eq!(
            by(merge_weights, cancelled),
            r#"{"weights": {"a": [[5, 1.50]], "b": [[5, -1.5]]}}"#
        );
    }

    proptest! {
        #[test]
        fn whatever_the_weights_the_text_stays_json(
            pairs in proptest::collection::vec((0_usize..3, 0_i64..4, any::<f32>()), 1..20),
        ) {
            let list = |bone: usize| {
                let own = pairs.iter().filter(|pair| pair.0 == bone && pair.2.is_finite());
                format!("\"{bone}\": [{}]", own.map(|(_, v, w)| format!("[{v}, {w}]")).collect::<Vec<_>>().join(", "))
            };
            let text = format!("{{\"weights\": {{{}}}}}", (0..3).map(list).collect::<Vec<_>>().join(", "));
            for operation in [merge_weights, drop_small_weights, normalize_weights] {
                prop_assert!(serde_json::from_str::<serde_json::Value>(&by(operation, &text)).is_ok());
            }
        }

        #[test]
        fn normalised_weights_load_to_what_they_were(
            pairs in proptest::collection::vec((0_i64..6, 0_u32..1000), 1..30), bones in 1_usize..5,
        ) {
            let list = |bone: usize| {
                let mut own: BTreeMap<i64, u32> = BTreeMap::new();
                own.extend(pairs.iter().enumerate().filter(|(at, _)| at % bones == bone).map(|(_, pair)| *pair));
                let pairs: Vec<String> = own.iter().map(|(v, w)| format!("[{v}, 0.{w:03}]")).collect();
                format!("\"{bone}\": [{}]", pairs.join(", "))
            };
            let text = format!("{{\"weights\": {{{}}}}}", (0..bones).map(list).collect::<Vec<_>>().join(", "));
            let (before, after) = (read(&text), read(&by(normalize_weights, &text)));
            prop_assert_eq!(after.facts.sum.off, 0);
            for (old, new) in before.bones.iter().zip(&after.bones) {
                for (old, new) in old.pairs.iter().zip(&new.pairs) {
                    let loaded = |pair: &crate::mhw::Pair, weights: &Weights| {
                        let sums = Sums::of(&weights.bones, weights.facts.vertices);
                        pair.weight / sums.of_pair(pair).unwrap()
                    };
                    let (old, new) = (loaded(old, &before), loaded(new, &after));
                    prop_assert!(old.is_nan() && new.is_nan() || (old - new).abs() <= 4.0 * f32::EPSILON, "{old} {new}");
                }
            }
        }
    }
}
