//! What the bones of a skeleton of MakeHuman 1 take of the weights of the base skeleton (formats/makehuman1.md §4).

use std::collections::{BTreeMap, BTreeSet};

use super::{Rig, rigs};
use crate::eval::makehuman1::remap::{RemapBone, sources};
use crate::formats::mhskel::{Bone, Skeleton};
use crate::repo::Body;

/// A skeleton that takes its weights through references.
pub(super) struct Remapped<'a> {
    /// The skeleton.
    pub(super) rig: Rig<'a>,
    /// For each bone places of those of the base skeleton that it takes.
    pub(super) sources: Vec<Vec<usize>>,
    /// Bones of the base skeleton that no bone takes.
    pub(super) untaken: Vec<&'a str>,
}

/// The skeletons without weights of their own.
pub(super) fn remapped<'v>(body: &Body<'v>) -> Vec<Remapped<'v>> {
    let Some(base) = body.default_rig().and_then(crate::repo::Rig::skeleton) else { return Vec::new() };
    let others = rigs(body).filter(|rig| !rig.own.is_default && rig.skeleton.weights_file.is_none());
    others.map(|rig| Remapped::of(base, rig)).collect()
}

impl<'a> Remapped<'a> {
    fn of(skeleton: &'a Skeleton, rig: Rig<'a>) -> Self {
        let ordered: Vec<(&str, Option<usize>)> = skeleton
            .breadth_first()
            .into_iter()
            .filter_map(|(place, parent)| Some((skeleton.bones.get(place)?.name.as_str(), parent)))
            .collect();
        let places: BTreeMap<&str, usize> =
            ordered.iter().enumerate().rev().map(|(place, (name, _))| (*name, place)).collect();
        let parents: Vec<Option<usize>> = ordered.iter().map(|(_, parent)| *parent).collect();
        let of = |bone: &Bone| -> (Vec<Option<usize>>, bool) {
            let (names, is_explicit) = bone.weight_references();
            (names.iter().map(|name| places.get(name).copied()).collect(), is_explicit)
        };
        let lists: Vec<(Vec<Option<usize>>, bool)> = rig.skeleton.bones.iter().map(of).collect();
        let bones = rig.skeleton.bones.iter().zip(&lists).map(|(bone, (references, is_explicit))| RemapBone {
            same_name: places.get(bone.name.as_str()).copied(),
            references,
            is_explicit: *is_explicit,
        });
        let bones: Vec<RemapBone<'_>> = bones.collect();
        let sources = sources(&parents, &bones);
        let taken: BTreeSet<usize> = sources.iter().flatten().copied().collect();
        let untaken = ordered.iter().enumerate().filter(|(place, _)| !taken.contains(place));
        Self { untaken: untaken.map(|(_, (name, _))| *name).collect(), rig, sources }
    }
}
