//! Skeletons with the weights that they name (`docs/loaders/makehuman1/skeletons.md#top-level`).

use super::search::Search;
use super::view::OWN;
use crate::{Layers, Reference, ReferenceKind, Rig};
use mhlint_diag::Place;
use mhlint_discover::Kind;

/// The skeleton that poses the body, which only the system has.
pub(super) const POSED: &str = "rigs/default.mhskel";

/// The skeletons of all layers, strongest first.
pub(super) fn rigs(layers: Layers<'_>) -> Vec<Rig<'_>> {
    let mut rigs = Vec::new();
    for layer in layers.strongest_first() {
        let is_system = layers
            .system
            .is_some_and(|system| std::ptr::eq(system, layer));
        for file in layer
            .below("rigs")
            .filter(|file| file.kind_in(OWN) == Kind::Skeleton)
        {
            let weights = file.skeleton().and_then(|skeleton| {
                let text = skeleton
                    .weights_file
                    .as_deref()
                    .filter(|text| !text.is_empty())?;
                let (rel, resolution) = Search {
                    layers,
                    layer,
                    file,
                }
                .find(text);
                Some(Reference {
                    kind: ReferenceKind::WeightsFile,
                    base: file.base_in(OWN)?,
                    from: file,
                    place: Place::pointer(["weights_file"]),
                    text,
                    owner: "",
                    folder_at_fault: None,
                    rel,
                    resolution,
                })
            });
            let is_default = is_system && file.rel == POSED;
            rigs.push(Rig {
                file,
                weights,
                is_default,
                is_found: true,
            });
        }
    }
    rigs
}
