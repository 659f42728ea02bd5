//! The targets at the two ends of sliders.

use std::collections::BTreeMap;

use super::{Body, FileFacts, Reference, ReferenceKind, View};
use mhlint_diag::{Place, grouped};

impl View<'_> {
    /// The targets of each slider that has two, by their paths; one for both sides of the body has
    /// them twice.
    pub fn slider_ends(&self) -> Vec<[&FileFacts; 2]> {
        use ReferenceKind::{Decr, Incr, Slot};
        let ends = self
            .references()
            .iter()
            .filter(|one| matches!(one.kind, Incr | Decr | Slot));
        let by_slider = grouped(
            ends.filter_map(|one| Some(((&one.from.path, one.owner, side(one)), one.found()?))),
        );
        by_slider.into_values().filter_map(two).collect()
    }

    /// Gives each body the ends of the sliders whose targets it has.
    pub(super) fn share_slider_ends<'v>(&'v self, bodies: &mut [Body<'v>]) {
        let numbered = bodies.iter().enumerate();
        let of_body = |(number, body): (usize, &Body<'v>)| {
            body.targets
                .iter()
                .map(move |one| (one.file.path.as_str(), number))
                .collect::<Vec<_>>()
        };
        let owner: BTreeMap<&str, usize> = numbered.flat_map(of_body).collect();
        for ends in self.slider_ends() {
            let [one, other] = ends.map(|file| owner.get(file.path.as_str()));
            let both = one.filter(|one| other == Some(one));
            if let Some(body) = both.and_then(|number| bodies.get_mut(*number)) {
                body.slider_ends.push(ends);
            }
        }
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
        Place::Pointer(pointer) if one.kind == ReferenceKind::Slot => {
            pointer.rsplit('-').next().unwrap_or_default()
        }
        _ => "",
    }
}
