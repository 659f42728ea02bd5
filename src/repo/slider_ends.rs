//! The targets at the two ends of sliders.

use super::{FileFacts, Reference, ReferenceKind, View};
use crate::diag::{Place, grouped};

impl View<'_> {
    /// The targets of each slider that has two, by their paths; one for both sides of the body has them twice.
    pub(crate) fn slider_ends(&self) -> Vec<[&FileFacts; 2]> {
        use ReferenceKind::{Decr, Incr, Slot};
        let ends = self.references().iter().filter(|one| matches!(one.kind, Incr | Decr | Slot));
        let by_slider = grouped(ends.filter_map(|one| Some(((&one.from.path, one.owner, side(one)), one.found()?))));
        by_slider.into_values().filter_map(two).collect()
    }
}

/// The files, if they are two different ones.
fn two(mut files: Vec<&FileFacts>) -> Option<[&FileFacts; 2]> {
    files.sort_unstable_by(|one, other| one.path.cmp(&other.path));
    files.dedup_by(|one, other| one.path == other.path);
    files.try_into().ok()
}

/// The side of the body that a slot is for, as its key ends.
fn side<'r>(one: &'r Reference<'_>) -> &'r str {
    match &one.place {
        Place::Pointer(pointer) if one.kind == ReferenceKind::Slot => pointer.rsplit('-').next().unwrap_or_default(),
        _ => "",
    }
}
