//! What becomes of the weights of a base.

use std::collections::BTreeSet;

use super::Base;
use super::rigs::name_of;
use crate::{BodyWeights, FileFacts, Reference, ReferenceKind, Rig, WeightsUse};

/// The weights of a base. Those that no skeleton names are never read; those of other skeletons
/// than the one for poses are loaded with these, and no more: even exports take the others
/// (`docs/loaders/makehuman2/skeletons.md#references`).
pub(super) fn weights<'v>(base: &'v Base<'_>) -> Vec<BodyWeights<'v>> {
    let can_tell = can_tell(base);
    let used: BTreeSet<&str> = base
        .rigs
        .iter()
        .filter_map(named)
        .map(|file| file.rel.as_str())
        .collect();
    let posed = base.pose_rig().and_then(|(rig, _)| named(rig));
    let used = |file: &FileFacts| match posed {
        _ if !used.contains(file.rel.as_str()) && can_tell => WeightsUse::Unread,
        Some(posed) if used.contains(file.rel.as_str()) && posed.rel != file.rel => {
            WeightsUse::Loaded
        }
        _ => WeightsUse::Applied,
    };
    let weights = |file: &&'v FileFacts| BodyWeights {
        file,
        name: Some(name_of(base.name, file)),
        used: used(file),
    };
    base.weights.iter().map(weights).collect()
}

fn named<'a>(rig: &Rig<'a>) -> Option<&'a FileFacts> {
    rig.weights.as_ref()?.meant()
}

fn can_tell(base: &Base<'_>) -> bool {
    // A skeleton that cannot be read may name any file.
    let mut skeletons = base.rigs.iter().map(Rig::skeleton);
    let is_clear =
        skeletons.all(|one| one.is_some_and(|one| one.is_object && !one.weights_file_misshapen));
    // What is not found may be any of the files here, under another name; a pose skeleton that is
    // not found may name any. Without `base.json` the base, and its skeletons with it, lie in
    // system data that was not given.
    let pose = base
        .named
        .iter()
        .filter(|reference| reference.kind == ReferenceKind::PoseSkeleton);
    let mut named = base
        .rigs
        .iter()
        .filter_map(|rig| rig.weights.as_ref())
        .chain(pose);
    is_clear
        && base.settings().is_some()
        && named.all(|reference: &Reference<'_>| reference.meant().is_some())
}
