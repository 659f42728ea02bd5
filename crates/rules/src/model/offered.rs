//! The materials that a line of a model may mean.

use std::collections::BTreeMap;

use mhlint_repo::makehuman2::View;
use mhlint_source::file_name;

/// The materials below a folder that a model can name, as it would name them.
pub(super) struct Offered<'v> {
    pub(super) folder: &'v str,
    pub(super) names: Vec<&'v str>,
    /// The first of each name, by what is behind its folders.
    pub(super) by_last: BTreeMap<&'v str, &'v str>,
}

impl<'v> Offered<'v> {
    pub(super) fn below(view: &View<'v>, folder: &'v str) -> Self {
        let layers = view.layers.strongest_first();
        let files = layers.flat_map(|layer| layer.below(folder));
        let below = files.filter_map(|file| file.rel.strip_prefix(folder)?.strip_prefix('/'));
        // A model cannot name a file with a space in its name.
        let is_nameable =
            |name: &&str| name.ends_with(".mhmat") && !name.contains(char::is_whitespace);
        let names: Vec<&str> = below.filter(is_nameable).collect();
        let mut by_last = BTreeMap::new();
        for name in &names {
            by_last.entry(file_name(name)).or_insert(*name);
        }
        Self {
            folder,
            names,
            by_last,
        }
    }
}
