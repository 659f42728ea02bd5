//! Which weights no skeleton uses.

use crate::repo::{Base, FileFacts, Reference, ReferenceKind, Repository};

/// Weights of a base that no skeleton names; none where nobody can tell.
pub(super) fn unbound<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Vec<&'a FileFacts> {
    // A skeleton that cannot be read may name any file.
    if base
        .skeletons
        .iter()
        .any(|file| file.skeleton().is_none_or(|skeleton| !skeleton.is_object || skeleton.weights_file_misshapen))
    {
        return Vec::new();
    }
    let used: Vec<&Reference<'_>> =
        repository.references_of(base).filter(|reference| reference.kind == ReferenceKind::WeightsFile).collect();
    // What is not found may be any of the files here, under another name; a pose skeleton that is not found may
    // name any. Without `base.json` the base, and its skeletons with it, lie in system data that was not given.
    let names_weights = |kind| matches!(kind, ReferenceKind::WeightsFile | ReferenceKind::PoseSkeleton);
    let mut named = repository.references_of(base).filter(|reference| names_weights(reference.kind));
    if named.any(|reference| reference.meant().is_none()) || base.settings().is_none() {
        return Vec::new();
    }
    let is_used = |file: &FileFacts| {
        let is_meant = |reference: &&Reference<'_>| reference.meant().is_some_and(|found| found.rel == file.rel);
        used.iter().any(is_meant)
    };
    base.weights.iter().copied().filter(|file| !is_used(file)).collect()
}
