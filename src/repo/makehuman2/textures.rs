//! Pictures that materials name, and where `MakeHuman` 2 looks for them (formats/makehuman2.md §17).

use std::collections::{BTreeMap, BTreeSet};

use super::OWN;
use crate::diag::Place;
use crate::discover::{Kind, extension, material_of};
use crate::formats::mhmat::Texture;
use crate::repo::path::resolve;
use crate::repo::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution, parent};

/// The pictures of all materials that the application opens, by base mesh.
pub(super) fn by_base(layers: Layers<'_>) -> BTreeMap<&str, Vec<Reference<'_>>> {
    let mut by_base: BTreeMap<&str, Vec<Reference<'_>>> = BTreeMap::new();
    for layer in layers.strongest_first() {
        let assets = folders_of_assets(layer);
        for file in layer.files.values().filter(|file| file.kind_in(OWN) == Kind::Material) {
            if let (Some(base), Some(search)) = (file.base_in(OWN), Search::of(layers, layer, file, &assets)) {
                by_base.entry(base).or_default().extend(search.references(base));
            }
        }
    }
    by_base
}

/// Folders with something to wear in them. Materials elsewhere are offered for nothing.
fn folders_of_assets(layer: &Layer) -> BTreeSet<&str> {
    let is_asset = |file: &&FileFacts| file.kind_in(OWN) == Kind::Clothes || extension(&file.rel) == "mhbin";
    layer.files.values().filter(is_asset).map(|file| parent(&file.rel)).collect()
}

/// A material with all that is asked for its pictures.
struct Search<'a> {
    file: &'a FileFacts,
    layer: &'a Layer,
    /// The folder that all assets of this sort are in, without that for the base mesh.
    folder: &'a str,
    /// Layers with such a folder.
    shared: Vec<&'a Layer>,
    /// Whether system data that is not at hand could have the picture.
    is_open: bool,
}

impl<'a> Search<'a> {
    fn of(layers: Layers<'a>, layer: &'a Layer, file: &'a FileFacts, assets: &BTreeSet<&str>) -> Option<Self> {
        let use_of = material_of(&file.rel)?;
        let mut above = std::iter::successors(Some(parent(&file.rel)), |folder| Some(parent(folder)))
            .take_while(|folder| !folder.is_empty());
        if use_of.is_worn && !above.any(|folder| assets.contains(folder)) {
            return None;
        }
        let settings = format!("base/{}", file.base_in(OWN)?);
        let has_base = layers.strongest_first().any(|layer| layer.below(&settings).next().is_some());
        let is_open = !has_base && (layers.system.is_none() || layers.is_one_root());
        let shared = layers.system.into_iter().chain(layers.user).collect();
        Some(Self { file, layer, folder: use_of.folder, shared, is_open })
    }

    /// Names that lead nowhere count for nothing where the same keyword names a picture that is there. One that leads out
    /// of the data is another matter: where a file is there, the application takes it.
    fn references(&self, base: &'a str) -> Vec<Reference<'a>> {
        let Some(material) = self.file.material() else { return Vec::new() };
        let all: Vec<_> = material.textures.iter().map(|texture| self.reference(base, texture)).collect();
        let found: BTreeSet<&str> = all.iter().filter(|one| one.found().is_some()).map(|one| one.owner).collect();
        let escapes = |one: &Reference<'_>| matches!(one.resolution, Resolution::Escapes);
        all.into_iter().filter(|one| one.found().is_some() || escapes(one) || !found.contains(one.owner)).collect()
    }

    fn reference(&self, base: &'a str, texture: &'a Texture) -> Reference<'a> {
        let (rel, resolution) = self.find(base, &texture.word);
        Reference {
            kind: ReferenceKind::Texture,
            base,
            from: self.file,
            place: Place::Span(texture.span.clone()),
            text: &texture.word,
            owner: texture.keyword,
            folder_at_fault: None,
            rel,
            resolution,
        }
    }

    /// The first place with the picture; without one, the place that comes nearest to it.
    fn find(&self, base: &str, word: &str) -> (String, Resolution<'a>) {
        let mut tried: Vec<(String, Resolution<'a>)> = Vec::new();
        for (layer, rel, text) in self.places(base, word) {
            let resolution = resolve(&[layer], text, &rel);
            let ends = matches!(resolution, Resolution::Found(_) | Resolution::Escapes);
            tried.push((rel, resolution));
            if ends {
                break;
            }
        }
        // Outside of the data there may be anything: what comes behind may never be reached.
        let escape = tried.pop_if(|(_, resolution)| matches!(resolution, Resolution::Escapes));
        let nearest = || tried.into_iter().min_by_key(|(_, resolution)| distance(resolution));
        let (rel, resolution) = escape.or_else(nearest).unwrap_or((String::new(), Resolution::Missing));
        let is_open = self.is_open && matches!(resolution, Resolution::Missing);
        (rel, if is_open { Resolution::NeedsSystem } else { resolution })
    }

    /// Where the picture is looked for, in order, and what of the name is left there.
    fn places<'w>(&self, base: &str, word: &'w str) -> Vec<(&'a Layer, String, &'w str)> {
        let folder = parent(&self.file.rel);
        let below = word.split_once('/').map(|(_, below)| below);
        let mut places = vec![(self.layer, format!("{folder}/{word}"), word)];
        if folder.ends_with("materials") {
            places.push((self.layer, format!("{}/{word}", parent(folder)), word));
        }
        places.extend(below.map(|below| (self.layer, format!("{folder}/{below}"), below)));
        let shared = below.filter(|_| word.starts_with(self.folder)).unwrap_or(word);
        places.extend(self.shared.iter().map(|layer| (*layer, format!("{}/{base}/{shared}", self.folder), shared)));
        places
    }
}

/// How far from the picture a place is: what is there outweighs what only another system finds, and that outweighs
/// nothing at all.
const fn distance(resolution: &Resolution<'_>) -> u8 {
    match resolution {
        Resolution::Found(_) => 0,
        Resolution::CaseOnly(_) | Resolution::Backslash(Some(_)) => 1,
        Resolution::Unusable => 2,
        Resolution::Absolute | Resolution::Escapes | Resolution::Backslash(None) => 3,
        Resolution::OtherLayer(_) | Resolution::Missing | Resolution::NeedsSystem => 4,
    }
}
