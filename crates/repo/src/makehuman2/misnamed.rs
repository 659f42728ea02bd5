//! Folders that no loader lists: with other capitals than the one that is looked for, or without
//! the folder of a base mesh.

use std::collections::{BTreeMap, BTreeSet};

use super::{OWN, View};
use crate::misnamed_folder::{MisnamedFolder, misnamed_folders, top_in_other_case};
use crate::{FileFacts, Layer, Layers, fold};
use mhlint_diag::grouped;
use mhlint_discover::Layout;

/// The files that stand in the folder of a base mesh and in no other place.
const OF_BASE: [&str; 3] = ["macro.json", "modelling.json", "target_cat.json"];

/// Whether any layer has something of the base mesh itself.
fn has_base(layers: Layers<'_>, name: &str) -> bool {
    layers
        .strongest_first()
        .any(|layer| layer.below(&format!("base/{name}")).next().is_some())
}

/// The names that are those of a base mesh, of all that folders are called where one should be.
pub(super) fn without_misnamed<'a>(
    layers: Layers<'a>,
    names: BTreeSet<&'a str>,
) -> BTreeSet<&'a str> {
    let known: BTreeMap<String, &str> = names
        .iter()
        .filter(|name| has_base(layers, name))
        .map(|name| (fold(name), *name))
        .collect();
    let is_meant = |name: &&str| {
        let other_case = known.get(&fold(name)).is_some_and(|known| known != name);
        let is_inside = || {
            layers
                .strongest_first()
                .any(|layer| unsorted_above(layer, name).is_some())
        };
        has_base(layers, name) || !other_case && !is_inside()
    };
    names.iter().copied().filter(is_meant).collect()
}

/// The folder in which the name is that of a folder of targets, because that of the base mesh is
/// left out.
fn unsorted_above(layer: &Layer, name: &str) -> Option<&'static str> {
    let has_targets = |folder: &&&str| layer.below(&format!("{folder}/{name}")).next().is_some();
    ["contarget", "target"]
        .iter()
        .filter(has_targets)
        .find(|folder| unsorted(layer, folder).is_some())
        .copied()
}

/// The first file in `contarget/` or `target/` itself that belongs in the folder of a base mesh.
fn unsorted<'a>(layer: &'a Layer, folder: &str) -> Option<&'a FileFacts> {
    OF_BASE
        .iter()
        .find_map(|name| layer.file(&format!("{folder}/{name}")))
}

impl<'a> View<'a> {
    /// Of each folder of the checked layer that lacks the folder of a base mesh in it a file that
    /// shows it.
    pub fn unsorted(&self) -> impl Iterator<Item = (&'static str, &'a FileFacts)> {
        let checked = self.layers.checked;
        ["contarget", "target"]
            .into_iter()
            .filter_map(move |folder| Some((folder, unsorted(checked, folder)?)))
    }

    /// Whether a target lies in such a folder: what its folder is called says nothing.
    pub fn is_unsorted(&self, file: &FileFacts) -> bool {
        self.unsorted()
            .any(|(folder, _)| file.rel.starts_with(&format!("{folder}/")))
    }

    /// The folders of the checked layer whose name differs in its capitals from the one that is
    /// looked for.
    pub fn misnamed_folders(&self) -> Vec<MisnamedFolder> {
        let layout = Layout::of(OWN);
        let known = self
            .bases
            .iter()
            .map(|base| base.name)
            .filter(|name| has_base(self.layers, name));
        let known = grouped(known.map(|name| (name.to_ascii_lowercase(), name)));
        // The base mesh that a name means but for its capitals.
        let in_other_case = |name: &str| {
            let alike = known.get(name.to_ascii_lowercase().as_str())?;
            alike.iter().find(|base| **base != name)
        };
        misnamed_folders(self.layers.checked, layout, |rel| {
            let of_base = || {
                let (top, rest) = rel.split_once('/')?;
                let (name, rest) = rest.split_once('/')?;
                let base = in_other_case(name)?;
                Some((format!("{top}/{name}"), format!("{top}/{base}"), rest))
            };
            top_in_other_case(layout, rel).or_else(of_base)
        })
    }
}
