//! Which weights no skeleton names.

use std::collections::BTreeSet;

use super::Base;
use crate::repo::{Reference, ReferenceKind, Rig};

/// Of each weights file of a base whether no skeleton names it; never where nobody can tell.
pub(super) fn unbound(base: &Base<'_>) -> Vec<bool> {
    let can_tell = can_tell(base);
    let used = base.rigs.iter().filter_map(|rig| Some(rig.weights.as_ref()?.meant()?.rel.as_str()));
    let used: BTreeSet<&str> = used.collect();
    let is_unbound = |rel: &str| can_tell && !used.contains(rel);
    base.weights.iter().map(|file| is_unbound(&file.rel)).collect()
}

fn can_tell(base: &Base<'_>) -> bool {
    // A skeleton that cannot be read may name any file.
    let mut skeletons = base.rigs.iter().map(Rig::skeleton);
    let is_clear = skeletons.all(|one| one.is_some_and(|one| one.is_object && !one.weights_file_misshapen));
    // What is not found may be any of the files here, under another name; a pose skeleton that is not found may
    // name any. Without `base.json` the base, and its skeletons with it, lie in system data that was not given.
    let pose = base.named.iter().filter(|reference| reference.kind == ReferenceKind::PoseSkeleton);
    let mut named = base.rigs.iter().filter_map(|rig| rig.weights.as_ref()).chain(pose);
    is_clear && base.settings().is_some() && named.all(|reference: &Reference<'_>| reference.meant().is_some())
}
