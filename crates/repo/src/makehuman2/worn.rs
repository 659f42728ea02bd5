//! What bodies can wear: assets that the scan finds (`docs/loaders/makehuman2/clothes.md#keywords`,
//! `docs/loaders/makehuman2/libraries.md#scan`).

use std::collections::BTreeSet;

use super::OWN;
use crate::{Layers, Worn};
use mhlint_discover::{Kind, Layout};
use mhlint_formats::mhclo;

/// The assets of all layers, sorted by base; those of one alone if it is named.
pub fn worn<'a>(layers: Layers<'a>, base: Option<&str>) -> Vec<Worn<'a>> {
    let scans = Layout::of(OWN).scans;
    // What is scanned lies in a folder of its base in one of these.
    let tops: BTreeSet<&str> = Layout::of(OWN).at_top().collect();
    let folders: Vec<String> = match base {
        Some(base) => tops.iter().map(|top| format!("{top}/{base}")).collect(),
        None => tops.into_iter().map(str::to_owned).collect(),
    };
    let mut worn: Vec<Worn<'_>> = Vec::new();
    for layer in layers.strongest_first() {
        let files = folders.iter().flat_map(|folder| layer.below(folder));
        let files = files.filter(|file| {
            matches!(file.kind_in(OWN), Kind::Clothes | Kind::Packed) && scans(&file.rel)
        });
        let of = |file| {
            Some(
                Worn::of(
                    layer,
                    file,
                    file.base_in(OWN)?,
                    &mhclo::makehuman2::READER,
                    true,
                )
                .beside_system(layers),
            )
        };
        worn.extend(files.filter_map(of));
    }
    worn.sort_by_key(|worn| worn.base);
    worn
}
