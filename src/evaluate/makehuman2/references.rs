//! Weights of the default skeleton handed to another one through the references of its bones (formats/makehuman2.md
//! §10.2).

use std::collections::BTreeSet;

use super::compose::first_places;
use crate::eval::makehuman2::transfer::{Transfer, TransferBone, transfer};
use crate::eval::measures::Received;
use crate::eval::scene::Scene;
use crate::eval::weights::BoneWeights;
use crate::formats::mhskel::Skeleton;

/// What the bones of `skeleton` receive. `number` finds a default bone by name; `parents` are those of the default bones.
pub(in crate::evaluate) fn through_references(
    weights: &[BoneWeights],
    parents: &[Option<usize>],
    skeleton: &Skeleton,
    number: impl Fn(&str) -> Option<usize>,
) -> Transfer {
    let numbers = |names: &Option<Vec<String>>| -> Vec<Option<usize>> {
        names.iter().flatten().map(|name| number(name)).collect()
    };
    let bones = skeleton.bones.iter();
    let lists: Vec<_> =
        bones.map(|bone| (number(&bone.name), numbers(&bone.reference), numbers(&bone.weights_reference))).collect();
    let bones: Vec<TransferBone<'_>> = lists
        .iter()
        .map(|(same_name, reference, weights_reference)| TransferBone {
            same_name: *same_name,
            reference,
            weights_reference,
        })
        .collect();
    transfer(weights, parents, &bones)
}

/// What another skeleton gets of the weights of the scene's, and what is lost.
pub(super) fn received(scene: &Scene, skeleton: &Skeleton) -> Received {
    let Some((default, weights)) = scene.skeleton.as_ref().zip(scene.weights.as_ref()) else {
        return Received::default();
    };
    let numbers = first_places(default.names.iter().map(String::as_str));
    let parents: Vec<Option<usize>> = default.bones.iter().map(|bone| bone.parent).collect();
    let moved = through_references(&weights.bones, &parents, skeleton, |name| numbers.get(name).copied());
    // Who takes what is enough to know; what is taken, many times perhaps, is never put together.
    let filled: BTreeSet<usize> =
        weights.bones.iter().filter(|list| !list.entries.is_empty()).map(|list| list.bone).collect();
    let is_bare = |sources: &Vec<usize>| !sources.iter().any(|source| filled.contains(source));
    let bare = skeleton.bones.iter().zip(&moved.sources).filter(|(_, sources)| is_bare(sources));
    let taken: BTreeSet<usize> = moved.sources.iter().flatten().copied().collect();
    let kept = vertices(weights.bones.iter().filter(|list| taken.contains(&list.bone)));
    Received {
        without_weights: bare.map(|(bone, _)| bone.name.clone()).collect(),
        lost_bones: moved.lost.iter().filter_map(|bone| default.names.get(*bone).cloned()).collect(),
        lost_vertices: vertices(&weights.bones).difference(&kept).copied().collect(),
    }
}

fn vertices<'w>(weights: impl IntoIterator<Item = &'w BoneWeights>) -> BTreeSet<u32> {
    weights.into_iter().flat_map(|list| &list.entries).map(|(vertex, _)| *vertex).collect()
}
