//! Which weights no skeleton uses.

use crate::repo::{Base, FileFacts, Reference, ReferenceKind, Repository, Resolution};

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
    if named.any(|reference| !leads_to_file(reference.resolution)) || base.settings().is_none() {
        return Vec::new();
    }
    let is_used = |file: &FileFacts| {
        let is_meant = |reference: &&Reference<'_>| match reference.resolution {
            Resolution::Found(found) | Resolution::CaseOnly(found) | Resolution::Backslash(Some(found)) => {
                found.rel == file.rel
            }
            _ => false,
        };
        used.iter().any(is_meant)
    };
    base.weights.iter().copied().filter(|file| !is_used(file)).collect()
}

fn leads_to_file(resolution: Resolution<'_>) -> bool {
    matches!(resolution, Resolution::Found(_) | Resolution::CaseOnly(_) | Resolution::Backslash(Some(_)))
}
