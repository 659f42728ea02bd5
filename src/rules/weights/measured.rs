//! The weights that evaluation measured: those of the pose skeleton.

use crate::repo::{Base, FileFacts, ReferenceKind, Repository, Resolution};

/// The weights file that the pose skeleton of a base loads.
pub(super) fn pose_weights<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Option<&'a FileFacts> {
    let found = |resolution: &Resolution<'a>| match resolution {
        Resolution::Found(file) => Some(*file),
        _ => None,
    };
    let references: Vec<_> = repository.references_of(base).collect();
    let pose = references.iter().find(|reference| reference.kind == ReferenceKind::PoseSkeleton)?;
    let pose = found(&pose.resolution)?;
    let is_bound = |kind, from: &FileFacts| kind == ReferenceKind::WeightsFile && from.path == pose.path;
    let weights = references.iter().find(|reference| is_bound(reference.kind, reference.from))?;
    found(&weights.resolution)
}
