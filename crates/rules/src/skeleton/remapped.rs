//! What the bones of a skeleton of MakeHuman 1 take of the weights of the base skeleton
//! (`docs/loaders/makehuman1/skeletons.md#references-and-weights`).

use std::collections::BTreeSet;

use super::{Rig, rigs};
use mhlint_eval::makehuman1::remap::{RemapBone, Sources, shared_sources};
use mhlint_formats::bone_references::{BoneReferences, NamedBones};
use mhlint_formats::mhskel::Skeleton;
use mhlint_repo::Body;

/// A skeleton that takes its weights through references.
pub(super) struct Remapped<'a> {
    /// The skeleton.
    pub(super) rig: Rig<'a>,
    /// Places of the bones of the base skeleton that its bones take.
    pub(super) sources: Sources,
    /// The names of the base skeleton.
    pub(super) base: Vec<&'a str>,
    /// Those of its bones that no bone takes.
    pub(super) untaken: Vec<&'a str>,
}

/// The skeletons without weights of their own.
pub(super) fn remapped<'v>(body: &Body<'v>) -> Vec<Remapped<'v>> {
    let Some(base) = body.default_rig().and_then(mhlint_repo::Rig::skeleton) else {
        return Vec::new();
    };
    let others =
        rigs(body).filter(|rig| !rig.own.is_default && rig.skeleton.weights_file.is_none());
    let most = MOST_WALKED / base.bones.len().max(1);
    others
        .take(most)
        .map(|rig| Remapped::of(base, rig))
        .collect()
}

/// Bones of the base skeleton that are walked for all others: skeletons times bones have no end.
/// With the base skeleton of the program these are 25 000 skeletons.
const MOST_WALKED: usize = 1 << 22;

impl<'a> Remapped<'a> {
    fn of(skeleton: &'a Skeleton, rig: Rig<'a>) -> Self {
        let named = BoneReferences::of(skeleton, rig.skeleton);
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
        let sources = shared_sources(&named.parents, &bones);
        let free = sources.free.iter().map(|free| &free.bones);
        let taken: BTreeSet<usize> = sources.own.iter().chain(free).flatten().copied().collect();
        let untaken = named
            .base
            .iter()
            .enumerate()
            .filter(|(place, _)| !taken.contains(place));
        let untaken = untaken.map(|(_, name)| *name).collect();
        Self {
            rig,
            sources,
            untaken,
            base: named.base,
        }
    }
}
