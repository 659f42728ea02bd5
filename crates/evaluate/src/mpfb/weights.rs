//! Weights as vertex groups: read, loaded, and as JSON.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Map, Value, json};

use super::rig::{RigFile, stops};
use crate::Error;
use crate::files::{json_cause, read_text, shown};
use crate::outputs::{object, rounded};
use mhlint_eval::mpfb::groups::{FileGroup, Loading, VertexGroup, load};
use mhlint_formats::mhw::{self, Weights};
use mhlint_json::Node;
use mhlint_source::Encoding;

/// Groups of a weights file: names, and vertices with weights.
pub type Lists = Vec<(String, Vec<(i64, f64)>)>;

/// Reads weights of a rig or of an asset.
///
/// # Errors
/// A file that cannot be read, and one that stops MPFB.
pub fn read_groups(path: &Path) -> Result<Lists, Error> {
    let bytes = read_text(path)?;
    let weights = mhw::parse(&bytes, &Encoding::of(&bytes), None);
    let weights = weights.map_err(|fault| Error::file(shown(path), json_cause(&fault, &bytes)))?;
    lists(&weights)
        .map_err(|(exception, reason)| stops(exception, format!("`{}`: {reason}", shown(path))))
}

fn lists(weights: &Weights) -> Result<Lists, (&'static str, String)> {
    if !weights.has_weights {
        return Err(("KeyError", "it has no `weights`".to_owned()));
    }
    let list = |bone: &mhw::BoneWeights| {
        if let Some(at) = bone.malformed.first() {
            return Err((
                "TypeError",
                format!(
                    "entry {at} of group `{}` is not a vertex and a weight",
                    bone.name
                ),
            ));
        }
        Ok((
            bone.name.clone(),
            bone.pairs
                .iter()
                .map(|pair| (pair.vertex, f64::from(pair.weight)))
                .collect(),
        ))
    };
    weights.bones.iter().map(list).collect()
}

/// Weights as they stand in a case.
pub(super) fn inline(node: &Node) -> Result<Lists, Error> {
    let pair = |node: &Node| match node.elements() {
        [vertex, weight] => Some((vertex.as_i64()?, weight.as_f64()?)),
        _ => None,
    };
    let wrong = |group: &str| {
        Error::Input(format!(
            "group `{group}` of the case has an entry that is not a pair"
        ))
    };
    let group = |member: &&mhlint_json::Member| {
        let pairs: Option<Vec<(i64, f64)>> = member.node.elements().iter().map(pair).collect();
        Ok((member.key.clone(), pairs.ok_or_else(|| wrong(&member.key))?))
    };
    node.effective_members().iter().map(group).collect()
}

/// The groups of lists, each vertex once.
pub(super) fn existing(lists: Lists) -> Vec<VertexGroup> {
    let entry = |(vertex, weight): (i64, f64)| Some((usize::try_from(vertex).ok()?, weight));
    let group = |(name, pairs): (String, Vec<(i64, f64)>)| {
        (name, pairs.into_iter().filter_map(entry).collect())
    };
    lists.into_iter().map(group).collect()
}

impl RigFile {
    /// The vertex groups that weights make on a mesh with so many vertices.
    pub fn groups(&self, lists: &[(String, Vec<(i64, f64)>)], vertices: usize) -> Vec<VertexGroup> {
        let file: Vec<FileGroup<'_>> = lists
            .iter()
            .map(|(name, pairs)| (name.as_str(), pairs.as_slice()))
            .collect();
        load(
            Vec::new(),
            &file,
            &self.takers(),
            Loading {
                vertices,
                ..Loading::default()
            },
        )
    }
}

/// Number of entries and sum of each group, and what chosen vertices have.
pub fn groups_json(groups: &[VertexGroup], chosen: &[i64]) -> Map<String, Value> {
    let sums = groups.iter().map(|(name, own)| {
        (
            name.clone(),
            json!([own.len(), rounded(own.values().sum())]),
        )
    });
    let of_vertex = |vertex: &i64| {
        let own = usize::try_from(*vertex).ok();
        let has =
            |(name, weights): &VertexGroup| Some(json!([name, rounded(*weights.get(&own?)?)]));
        json!([vertex, groups.iter().filter_map(has).collect::<Vec<_>>()])
    };
    let mut totals: BTreeMap<usize, f64> = BTreeMap::new();
    for (vertex, weight) in groups.iter().flat_map(|(_, own)| own) {
        *totals.entry(*vertex).or_default() += weight;
    }
    let least = totals.values().copied().reduce(f64::min);
    let most = totals.values().copied().reduce(f64::max);
    object([
        ("groups", Value::Object(sums.collect())),
        ("vertices", chosen.iter().map(of_vertex).collect()),
        ("weighted_vertices", Value::from(totals.len())),
        (
            "vertex_sum_range",
            least.zip(most).map_or(Value::Null, |(least, most)| {
                json!([rounded(least), rounded(most)])
            }),
        ),
    ])
}

/// All entries of all groups.
pub(super) fn lists_json(groups: &[VertexGroup]) -> Map<String, Value> {
    let list = |own: &BTreeMap<usize, f64>| {
        own.iter()
            .map(|(vertex, weight)| json!([vertex, rounded(*weight)]))
            .collect()
    };
    let groups = groups
        .iter()
        .map(|(name, own)| (name.clone(), Value::Array(list(own))));
    object([("weights", Value::Object(groups.collect()))])
}
