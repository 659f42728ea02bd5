//! What the bones of a skeleton of MakeHuman 1 take of the weights of the base skeleton
//! (`docs/loaders/makehuman1/skeletons.md#references-and-weights`).

use std::collections::BTreeSet;

use super::{Rig, rigs};
use mhlint_eval::makehuman1::remap::{RemapBone, sources};
use mhlint_formats::bone_references::{BoneReferences, NamedBones};
use mhlint_formats::mhskel::Skeleton;
use mhlint_repo::Body;

/// A skeleton that takes its weights through references.
pub(super) struct Remapped<'a> {
    /// The skeleton.
    pub(super) rig: Rig<'a>,
    /// For each bone places of those of the base skeleton that it takes.
    pub(super) sources: Vec<Vec<usize>>,
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
    others.map(|rig| Remapped::of(base, rig)).collect()
}

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
        let sources = sources(&named.parents, &bones);
        let taken: BTreeSet<usize> = sources.iter().flatten().copied().collect();
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
