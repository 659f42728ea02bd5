//! Weights as MakeHuman 1 loads them, hands them to other skeletons and keeps the strongest
//! (`docs/loaders/makehuman1/weights.md#loading-weights`,
//! `docs/loaders/makehuman1/skeletons.md#references-and-weights`).

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use super::stopped;
use crate::Error;
use crate::data::NamedWeights;
use crate::makehuman2::WeightLists;
use crate::makehuman2::weights::{MOST_VERTICES, number};
use mhlint_eval::influences::{Influence, Influences};
use mhlint_eval::makehuman1::remap::{RemapBone, sources, taken};
use mhlint_eval::makehuman1::weights::{LIMITS, load, strongest};
use mhlint_eval::scene::Scene;
use mhlint_eval::skeleton::SceneSkeleton;
use mhlint_eval::weights::{BoneWeights, Entry, LoadedWeights};
use mhlint_formats::bone_references::{BoneReferences, NamedBones};
use mhlint_formats::mhskel::{Bone, Skeleton};
use mhlint_formats::mhw::Weights;

/// Weights with bones numbered as in the skeleton; those of bones that it lacks count for the sums
/// and are dropped.
pub(super) fn bind(
    skeleton: &SceneSkeleton,
    weights: &Weights,
    scene: &Scene,
) -> Option<LoadedWeights> {
    let root = skeleton
        .bones
        .iter()
        .position(|bone| bone.parent.is_none())?;
    let lists = WeightLists::from(weights.clone());
    let named = loaded(&lists, skeleton.names.get(root)?, scene.positions.len()).ok()?;
    let places: BTreeMap<&str, usize> = skeleton
        .names
        .iter()
        .enumerate()
        .rev()
        .map(|(place, name)| (name.as_str(), place))
        .collect();
    let bone = |list: BoneWeights| {
        let place = places.get(named.names.get(list.bone)?.as_str())?;
        Some(BoneWeights {
            bone: *place,
            ..list
        })
    };
    let bones = named.loaded.bones.into_iter().filter_map(bone).collect();
    Some(LoadedWeights {
        bones,
        ..named.loaded
    })
}

/// Lists loaded for a mesh of so many vertices; what is without weights goes to `root`.
///
/// # Errors
/// Vertices that the mesh does not have.
pub fn loaded(lists: &WeightLists, root: &str, vertices: usize) -> Result<NamedWeights, Error> {
    if vertices > MOST_VERTICES {
        return Err(Error::Input(format!(
            "{vertices} vertices are too many to evaluate (at most {MOST_VERTICES})"
        )));
    }
    let mut names: Vec<String> = lists.bones.iter().map(|(name, _)| name.clone()).collect();
    let root = number(&mut names, root);
    let mut entries: Vec<(usize, Vec<Entry>)> = Vec::new();
    for (bone, (name, pairs)) in lists.bones.iter().enumerate() {
        let entry = |pair: &mhlint_formats::mhw::Pair| {
            let outside = || {
                format!(
                    "bone `{name}` has vertex {}, but the mesh has {vertices} vertices",
                    pair.vertex
                )
            };
            let vertex =
                u32::try_from(pair.vertex).map_err(|_| super::stops("IndexError", outside()))?;
            Ok((vertex, pair.weight))
        };
        entries.push((bone, pairs.iter().map(entry).collect::<Result<_, Error>>()?));
    }
    let slices: Vec<(usize, &[Entry])> = entries
        .iter()
        .map(|(bone, list)| (*bone, list.as_slice()))
        .collect();
    let loaded = load(&slices, root, vertices).map_err(stopped)?;
    Ok(NamedWeights { names, loaded })
}

/// For each bone of another skeleton the bones of the base skeleton whose weights it takes, in the
/// order of both; behind them names that the base skeleton lacks, which stay in the list and give
/// nothing.
pub fn weight_references(base: &Skeleton, other: &Skeleton) -> Vec<(String, Vec<String>)> {
    let taken = References::of(base, other);
    let known: BTreeSet<&str> = taken.base.iter().copied().collect();
    let of = |(bone, sources): (&Bone, &Vec<usize>)| {
        let found = sources
            .iter()
            .filter_map(|place| taken.base.get(*place))
            .copied();
        let unknown = bone
            .weight_references()
            .0
            .into_iter()
            .filter(|name| !known.contains(name));
        (
            bone.name.clone(),
            found.chain(unknown).map(str::to_owned).collect(),
        )
    };
    other.bones.iter().zip(&taken.sources).map(of).collect()
}

/// Weights of the base skeleton on another one.
///
/// # Errors
/// Vertices beyond the mesh; a skeleton without a root.
pub fn remapped(
    weights: &NamedWeights,
    base: &Skeleton,
    other: &Skeleton,
    vertices: usize,
) -> Result<NamedWeights, Error> {
    let references = References::of(base, other);
    let places: BTreeMap<&str, usize> = references
        .base
        .iter()
        .enumerate()
        .rev()
        .map(|(place, name)| (*name, place))
        .collect();
    let of = |list: &BoneWeights| {
        let place = places.get(weights.names.get(list.bone)?.as_str())?;
        Some(BoneWeights {
            bone: *place,
            ..list.clone()
        })
    };
    let bound: Vec<BoneWeights> = weights.loaded.bones.iter().filter_map(of).collect();
    let moved = taken(&bound, &references.sources);
    let slices: Vec<(usize, &[Entry])> = moved
        .iter()
        .map(|list| (list.bone, list.entries.as_slice()))
        .collect();
    let order = other.breadth_first();
    let (root, _) = order
        .first()
        .ok_or_else(|| super::stops("IndexError", "the skeleton has no root".to_owned()))?;
    let loaded = load(&slices, *root, vertices).map_err(stopped)?;
    Ok(NamedWeights {
        names: other.bones.iter().map(|bone| bone.name.clone()).collect(),
        loaded,
    })
}

/// The bones of a base skeleton in its order, and what those of another one take of them.
struct References<'s> {
    base: Vec<&'s str>,
    sources: Vec<Vec<usize>>,
}

impl<'s> References<'s> {
    fn of(base: &'s Skeleton, other: &Skeleton) -> Self {
        let named = BoneReferences::of(base, other);
        let bones: Vec<RemapBone<'_>> = named
            .bones
            .iter()
            .map(
                |NamedBones {
                     same_name,
                     references,
                     is_explicit,
                 }| RemapBone {
                    same_name: *same_name,
                    references,
                    is_explicit: *is_explicit,
                },
            )
            .collect();
        Self {
            sources: sources(&named.parents, &bones),
            base: named.base,
        }
    }
}

/// Bones that move a vertex in a pose, at most.
const POSING: usize = 6;

/// The weights that a pose moves a mesh by: of each vertex the strongest.
///
/// # Errors
/// Weights of vertices beyond the mesh.
pub(crate) fn posing_weights(
    weights: &[BoneWeights],
    vertices: usize,
) -> Result<Vec<BoneWeights>, Error> {
    let mut lists: BTreeMap<usize, Vec<Entry>> = BTreeMap::new();
    for (vertex, influences) in (0..).zip(strongest(weights, POSING, vertices).map_err(stopped)?) {
        for (bone, weight) in influences.into_iter().filter(|(_, weight)| *weight != 0.0) {
            lists.entry(bone).or_default().push((vertex, weight));
        }
    }
    Ok(lists
        .into_iter()
        .map(|(bone, entries)| BoneWeights { bone, entries })
        .collect())
}

/// Weights of the strongest bones of each vertex, the bones in this order, with what that changed.
///
/// # Errors
/// A number of bones that the application has no table for; vertices beyond the mesh.
pub fn reduced(
    weights: &NamedWeights,
    bones: Vec<String>,
    limit: usize,
    vertices: usize,
) -> Result<(NamedWeights, Value), Error> {
    let influences = Influences::new(&weights.loaded.bones, vertices).map_err(stopped)?;
    let most = influences.iter().map(<[Influence]>::len).max().unwrap_or(0);
    if most > 1 && !LIMITS.contains(&limit) {
        let reason =
            format!("there is no table of {limit} bones a vertex, only of 1 to 6 and of 13");
        return Err(super::stops("ValueError", reason));
    }
    let more = influences.iter().filter(|of| of.len() > limit).count();
    let mut lists: BTreeMap<usize, Vec<Entry>> = BTreeMap::new();
    for (vertex, influences) in (0..).zip(compiled(weights, &bones, limit, vertices)?) {
        for (bone, weight) in influences.into_iter().filter(|(_, weight)| *weight != 0.0) {
            lists.entry(bone).or_default().push((vertex, weight));
        }
    }
    let kept = lists
        .into_iter()
        .map(|(bone, entries)| BoneWeights { bone, entries })
        .collect();
    let loaded = LoadedWeights {
        bones: kept,
        ..weights.loaded.clone()
    };
    let told = json!({ "max_influences": limit, "most_before": most, "vertices_reduced": more });
    Ok((
        NamedWeights {
            names: bones,
            loaded,
        },
        told,
    ))
}

/// The strongest bones of each vertex by name.
///
/// # Errors
/// Vertices beyond the mesh.
pub(super) fn compiled(
    weights: &NamedWeights,
    bones: &[String],
    limit: usize,
    vertices: usize,
) -> Result<Vec<Vec<Influence>>, Error> {
    let places: BTreeMap<&str, usize> = bones
        .iter()
        .enumerate()
        .rev()
        .map(|(place, name)| (name.as_str(), place))
        .collect();
    let of = |list: &BoneWeights| {
        let place = places.get(weights.names.get(list.bone)?.as_str())?;
        Some(BoneWeights {
            bone: *place,
            ..list.clone()
        })
    };
    let lists: Vec<BoneWeights> = weights.loaded.bones.iter().filter_map(of).collect();
    strongest(&lists, limit, vertices).map_err(stopped)
}
