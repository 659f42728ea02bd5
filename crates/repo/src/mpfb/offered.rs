//! The rigs that MPFB offers for a character, whether their files exist or not
//! (`docs/loaders/mpfb/rigs.md#where-rigs-lie`).

use crate::Layer;

const OFFERED: [&str; 10] = [
    "rigs/standard/rig.default.json",
    "rigs/standard/rig.default_no_toes.json",
    "rigs/standard/rig.game_engine.json",
    "rigs/standard/rig.game_engine_with_breast.json",
    "rigs/standard/rig.cmu_mb.json",
    "rigs/standard/rig.mixamo.json",
    "rigs/standard/rig.mixamo_unity.json",
    "rigs/standard/rig.openpose.json",
    "rigs/rigify/rig.human.json",
    "rigs/rigify/rig.human_toes.json",
];

/// Offered rigs that were here: their weights are, or a file of the name in other capitals. Which
/// of the others belong to this version of the add-on nobody knows.
pub fn lost_rigs(system: &Layer) -> impl Iterator<Item = &'static str> {
    let was_here = move |rel: &str| {
        system.is_there(&weights_of(rel)) || system.file_ignoring_case(rel).is_some()
    };
    OFFERED
        .into_iter()
        .filter(move |rel| !system.is_there(rel) && was_here(rel))
}

/// Whether these are the weights of such a rig.
pub(super) fn is_of_lost_rig(system: &Layer, weights: &str) -> bool {
    lost_rigs(system).any(|rig| weights_of(rig) == weights)
}

fn weights_of(rig: &str) -> String {
    rig.replace("/rig.", "/weights.")
}
