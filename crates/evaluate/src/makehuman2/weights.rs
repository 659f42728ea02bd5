//! Weights by bone name: read, loaded as the application does, moved to another skeleton, written.

use std::fmt::Write as _;
use std::path::Path;

use super::compose::first_places;
use super::references::through_references;
use super::{stopped, stops};
use crate::Error;
use crate::data::{NamedWeights, SkeletonFile};
use crate::files::{json_cause, read_text, shown};
use mhlint_eval::influences::{Influences, Reduction};
use mhlint_eval::load::load;
use mhlint_eval::weights::{BoneWeights, Entry, LoadedWeights};
use mhlint_formats::mhw::{self, Pair, Weights};
use mhlint_source::Encoding;

/// More vertices than this are not believed; the largest base has 20 thousand.
pub(crate) const MOST_VERTICES: usize = 1 << 20;
/// More entries than this are not handed on: a few references to one bone with many weights make
/// any number of them.
const MOST_ENTRIES: usize = 1 << 22;

/// The lists of a weights file.
#[derive(Debug, Clone, Default)]
pub struct WeightLists {
    /// Name of each bone and its vertices with weights, in file order.
    pub bones: Vec<(String, Vec<Pair>)>,
}

/// Reads a `.mhw`.
///
/// # Errors
/// A file that cannot be read, or is no weights file.
pub fn read_weights(path: &Path) -> Result<WeightLists, Error> {
    let fault = |reason: String| Error::file(shown(path), reason);
    let bytes = read_text(path)?;
    let weights = mhw::parse(&bytes, &Encoding::of(&bytes), None)
        .map_err(|f| fault(json_cause(&f, &bytes)))?;
    if !weights.has_weights {
        return Err(fault("the object `weights` is missing".to_owned()));
    }
    if let Some((bone, position, ..)) = weights.facts.malformed.first.first() {
        return Err(fault(format!(
            "entry {position} of bone `{bone}` is not a pair [vertex, weight]"
        )));
    }
    Ok(weights.into())
}

impl From<Weights> for WeightLists {
    fn from(weights: Weights) -> Self {
        Self {
            bones: weights
                .bones
                .into_iter()
                .map(|bone| (bone.name, bone.pairs))
                .collect(),
        }
    }
}

impl WeightLists {
    /// Highest vertex plus one.
    pub fn vertices_named(&self) -> usize {
        let vertices = self
            .bones
            .iter()
            .flat_map(|(_, pairs)| pairs)
            .map(|pair| pair.vertex);
        vertices
            .max()
            .and_then(|vertex| usize::try_from(vertex).ok())
            .map_or(0, |vertex| vertex.saturating_add(1))
    }

    /// Loads for a mesh of `vertices`; what is without weights goes to `root`.
    ///
    /// # Errors
    /// Vertices that the mesh does not have: `IndexError` as in the application, `OverflowError`
    /// for negative ones.
    pub fn load(&self, root: &str, vertices: usize) -> Result<NamedWeights, Error> {
        if vertices > MOST_VERTICES {
            return Err(Error::Input(format!(
                "{vertices} vertices are too many to evaluate (at most {MOST_VERTICES})"
            )));
        }
        self.check(vertices)?;
        let mut names: Vec<String> = self.bones.iter().map(|(name, _)| name.clone()).collect();
        let root = number(&mut names, root);
        let entry = |pair: &Pair| Some((u32::try_from(pair.vertex).ok()?, pair.weight));
        let lists: Vec<Vec<Entry>> = self
            .bones
            .iter()
            .map(|(_, pairs)| pairs.iter().filter_map(entry).collect())
            .collect();
        let slices: Vec<(usize, &[Entry])> = lists.iter().map(Vec::as_slice).enumerate().collect();
        let loaded = load(&slices, root, vertices).map_err(stopped)?;
        Ok(NamedWeights { names, loaded })
    }

    /// The sums over all bones come first in the application and take negative numbers from the
    /// end; storing does not.
    fn check(&self, vertices: usize) -> Result<(), Error> {
        let all = || {
            self.bones
                .iter()
                .flat_map(|(bone, pairs)| pairs.iter().map(move |pair| (bone, pair.vertex)))
        };
        let stop = |exception, (bone, vertex): (&String, i64)| {
            stops(
                exception,
                format!("bone `{bone}` has vertex {vertex}, but the mesh has {vertices} vertices"),
            )
        };
        let count = i64::try_from(vertices).unwrap_or(i64::MAX);
        if let Some(found) = all().find(|(_, vertex)| *vertex >= count || *vertex < -count) {
            return Err(stop("IndexError", found));
        }
        all()
            .find(|(_, vertex)| *vertex < 0)
            .map_or(Ok(()), |found| Err(stop("OverflowError", found)))
    }
}

/// Number of a name, which is added if it is new.
pub(crate) fn number(names: &mut Vec<String>, name: &str) -> usize {
    names
        .iter()
        .position(|known| known == name)
        .unwrap_or_else(|| {
            names.push(name.to_owned());
            names.len() - 1
        })
}

/// Weights of the default skeleton moved to another one through its references
/// (`docs/loaders/makehuman2/skeletons.md#references`), and the default bones whose weights are
/// lost.
///
/// # Errors
/// A default skeleton that the application refuses; more entries than are handed on.
pub fn transferred(
    weights: &NamedWeights,
    default: &SkeletonFile,
    other: &SkeletonFile,
) -> Result<(NamedWeights, Vec<String>), Error> {
    default.root()?;
    let names: Vec<&str> = default
        .model
        .bones
        .iter()
        .map(|bone| bone.name.as_str())
        .collect();
    let numbers = first_places(names.iter().copied());
    let find = |name: &str| numbers.get(name).copied();
    let parents: Vec<Option<usize>> = default
        .model
        .bones
        .iter()
        .map(|bone| bone.parent.as_deref().and_then(find))
        .collect();
    let bound: Vec<BoneWeights> = weights
        .loaded
        .bones
        .iter()
        .filter_map(|list| {
            Some(BoneWeights {
                bone: find(weights.names.get(list.bone)?)?,
                ..list.clone()
            })
        })
        .collect();
    let moved = through_references(&bound, &parents, &other.model, find);
    let entries = moved.entries_taken(&bound);
    if entries > MOST_ENTRIES {
        return Err(Error::Input(format!(
            "the references give {entries} weights, too many to evaluate (at most {MOST_ENTRIES})"
        )));
    }
    let lost = moved
        .lost
        .iter()
        .filter_map(|bone| names.get(*bone))
        .map(|name| (*name).to_owned())
        .collect();
    let loaded = LoadedWeights {
        bones: moved.taken(&bound),
        ..weights.loaded.clone()
    };
    Ok((
        NamedWeights {
            names: other
                .model
                .bones
                .iter()
                .map(|bone| bone.name.clone())
                .collect(),
            loaded,
        },
        lost,
    ))
}

/// The text of a `.mhw`, laid out as the shipped ones: a bone a block, four pairs a line.
pub fn to_mhw(weights: &NamedWeights, name: &str) -> String {
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let mut out = format!(
        "{{\n\"name\": {},\n\"version\": 110,\n\"weights\": {{",
        quoted(name)
    );
    for (place, list) in weights.loaded.bones.iter().enumerate() {
        let bone = weights.names.get(list.bone).map_or("", String::as_str);
        out.push_str(if place == 0 { "\n\t" } else { ",\n\t" });
        // Writing to a text cannot fail.
        let _ = write!(out, "{}: [", quoted(bone));
        for (at, (vertex, weight)) in list.entries.iter().enumerate() {
            let comma = if at == 0 { "" } else { "," };
            let space = if at % 4 == 0 { "\n\t\t" } else { " " };
            let _ = write!(out, "{comma}{space}[{vertex}, {weight}]");
        }
        out.push_str(if list.entries.is_empty() {
            "]"
        } else {
            "\n\t]"
        });
    }
    out.push_str("\n}\n}\n");
    out
}

impl NamedWeights {
    /// The bones of every vertex.
    ///
    /// # Errors
    /// Weights of vertices beyond `vertices`.
    pub fn influences(&self, vertices: usize) -> Result<Influences, Error> {
        Influences::new(&self.loaded.bones, vertices).map_err(stopped)
    }

    /// Keeps the strongest `limit` bones of every vertex.
    ///
    /// # Errors
    /// Weights of vertices beyond `vertices`.
    pub fn reduce(&mut self, limit: usize, vertices: usize) -> Result<Reduction, Error> {
        let reduction = self.influences(vertices)?.reduce(limit);
        let mut lists: Vec<Vec<Entry>> = vec![Vec::new(); self.names.len()];
        for (vertex, influences) in (0..).zip(reduction.influences.iter()) {
            for (bone, weight) in influences {
                if let Some(list) = lists.get_mut(*bone) {
                    list.push((vertex, *weight));
                }
            }
        }
        for bone in &mut self.loaded.bones {
            bone.entries = lists
                .get_mut(bone.bone)
                .map(std::mem::take)
                .unwrap_or_default();
        }
        Ok(reduction)
    }
}
