//! Where MakeHuman 1 looks for a file that another one names
//! (`docs/loaders/makehuman1/folders.md#search-for-named-files`).

use crate::path::resolve;
use crate::{FileFacts, Layer, Layers, Resolution};
use mhlint_source::{normalized, parent};

/// A file that names others.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    /// All layers.
    pub layers: Layers<'a>,
    /// The one of the file.
    pub layer: &'a Layer,
    /// The file.
    pub file: &'a FileFacts,
}

impl<'a> Search<'a> {
    /// The first place with the file, from its own folder on; without one, the place that comes
    /// nearest to it.
    pub(super) fn find(&self, text: &str) -> (String, Resolution<'a>) {
        self.find_from(&[(self.layer, parent(&self.file.rel))], text)
    }

    /// The same from other folders on.
    pub(super) fn find_from(
        &self,
        first: &[(&'a Layer, &str)],
        text: &str,
    ) -> (String, Resolution<'a>) {
        let mut nearest: Option<(String, Resolution<'a>)> = None;
        for (layer, rel, text) in self.places(first, text) {
            let resolution = resolve(&[layer], text, &rel);
            let found = (normalized(&rel).unwrap_or(rel), resolution);
            if matches!(resolution, Resolution::Found(_)) {
                return found;
            }
            // Nobody who writes `../x.png` means a file beside the data folder.
            if nearest.is_some() && matches!(resolution, Resolution::Escapes) {
                continue;
            }
            if nearest
                .as_ref()
                .is_none_or(|(_, other)| resolution.distance() < other.distance())
            {
                nearest = Some(found);
            }
        }
        let (rel, resolution) = nearest.unwrap_or((String::new(), Resolution::Missing));
        let resolution = resolution.in_pack(&[self.layer], self.file, text);
        // Pictures are in folders of the system data, never at its top.
        let could_be_there = text.contains('/') && !text.starts_with('.');
        let is_open = self.layers.system.is_none()
            && could_be_there
            && matches!(resolution, Resolution::Missing);
        if is_open {
            return (
                text.strip_prefix("data/").unwrap_or(text).to_owned(),
                Resolution::NeedsSystem,
            );
        }
        (rel, resolution)
    }

    /// The first folders, then the data of the user and of the system; at last the same without
    /// `data/` in front.
    fn places<'w>(
        &self,
        first: &[(&'a Layer, &str)],
        text: &'w str,
    ) -> Vec<(&'a Layer, String, &'w str)> {
        let mut places = Vec::new();
        for text in [Some(text), text.strip_prefix("data/")]
            .into_iter()
            .flatten()
        {
            places.extend(
                first
                    .iter()
                    .map(|(layer, folder)| (*layer, format!("{folder}/{text}"), text)),
            );
            let shared = self.layers.strongest_first().chain(self.layers.beside);
            places.extend(shared.map(|layer| (layer, text.to_owned(), text)));
        }
        places
    }
}
