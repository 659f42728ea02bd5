//! What bodies can wear: assets that the scan finds (`docs/loaders/makehuman2/clothes.md#keywords`,
//! `docs/loaders/makehuman2/libraries.md#scan`).

use super::OWN;
use crate::{Layers, Worn};
use mhlint_discover::{Kind, Layout};

/// The assets of all layers, sorted by base; those of one alone if it is named.
pub fn worn<'a>(layers: Layers<'a>, base: Option<&str>) -> Vec<Worn<'a>> {
    let scans = Layout::of(OWN).scans;
    let mut worn: Vec<Worn<'_>> = Vec::new();
    for layer in layers.strongest_first() {
        let files = layer
            .files
            .values()
            .filter(|file| matches!(file.kind_in(OWN), Kind::Clothes | Kind::Packed));
        let files = files.filter(|file| {
            base.is_none_or(|base| file.base_in(OWN) == Some(base)) && scans(&file.rel)
        });
        let of = |file| {
            Some(Worn::of(layer, file, file.base_in(OWN)?, |_| true, true).beside_system(layers))
        };
        worn.extend(files.filter_map(of));
    }
    worn.sort_by_key(|worn| worn.base);
    worn
}
