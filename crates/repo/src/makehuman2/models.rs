//! Saved characters: what they name, and who wears an asset
//! (`docs/loaders/makehuman2/models.md#assets-of-a-model`).

use std::collections::BTreeMap;

use super::{Asset, Base, Library, OWN};
use crate::path::resolve;
use crate::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution, Worn};
use mhlint_diag::Place;
use mhlint_discover::{Kind, listed_in};
use mhlint_formats::mhm::{MaterialLine, Model, Word};
use mhlint_source::parent;

/// A character that can be loaded.
#[derive(Debug, Clone, Copy)]
pub struct SavedModel<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub model: &'a Model,
    /// Whether it is loaded with the base.
    pub is_start: bool,
}

/// The characters of a base, of all layers: those of the list, and the one that is loaded at start.
pub(super) fn models<'a>(layers: Layers<'a>, base: &Base<'a>) -> Vec<SavedModel<'a>> {
    let start = base
        .named
        .iter()
        .filter(|one| one.kind == ReferenceKind::Model)
        .find_map(Reference::found);
    let folder = format!("models/{}", base.name);
    let listed = layers
        .strongest_first()
        .flat_map(|layer| layer.below(&folder));
    let listed =
        listed.filter(|file| file.kind_in(OWN) == Kind::Model && listed_in(&file.rel).is_some());
    let start = start.into_iter().map(|file| (file, true));
    let all = start.chain(listed.map(|file| (file, false)));
    all.filter_map(|(file, is_start)| {
        Some(SavedModel {
            file,
            model: file.model()?,
            is_start,
        })
    })
    .collect()
}

/// The files that characters name: skins, skeletons, materials.
pub(super) fn references<'a>(
    layers: Layers<'a>,
    base: &Base<'a>,
    models: &[SavedModel<'a>],
    library: &Library<'a>,
    is_open: bool,
) -> Vec<Reference<'a>> {
    let search = Search {
        layers,
        base: base.name,
        is_open,
    };
    let mut all = Vec::new();
    for SavedModel { file, model, .. } in models {
        all.extend(model.skin.as_ref().map(|word| search.skin(file, word)));
        all.extend(
            model
                .skeleton
                .as_ref()
                .map(|word| search.skeleton(file, word)),
        );
        for line in &model.materials {
            let asset = library.worn(base.name, &line.name.text, &line.uuid);
            all.extend(asset.map(|asset| search.material(file, line, asset)));
        }
    }
    all
}

struct Search<'a> {
    layers: Layers<'a>,
    base: &'a str,
    /// Whether system data that is not at hand could have what is missing.
    is_open: bool,
}

impl<'a> Search<'a> {
    /// System before user, with or without the folder of all skins in front.
    fn skin(&self, from: &'a FileFacts, word: &'a Word) -> Reference<'a> {
        let name = word.text.strip_prefix("skins/").unwrap_or(&word.text);
        let layers: Vec<&Layer> = self
            .layers
            .system
            .into_iter()
            .chain(self.layers.user)
            .collect();
        self.reference(
            &layers,
            ReferenceKind::Skin,
            from,
            word,
            format!("skins/{}/{name}", self.base),
        )
    }

    fn skeleton(&self, from: &'a FileFacts, word: &'a Word) -> Reference<'a> {
        let layers: Vec<&Layer> = self.layers.strongest_first().collect();
        self.reference(
            &layers,
            ReferenceKind::ModelSkeleton,
            from,
            word,
            format!("rigs/{}/{}", self.base, word.text),
        )
    }

    /// In the folder of the asset, or, without its first part, in that of its category.
    fn material(
        &self,
        from: &'a FileFacts,
        line: &'a MaterialLine,
        asset: &Asset<'_>,
    ) -> Reference<'a> {
        let layers: Vec<&Layer> = self.layers.strongest_first().collect();
        let kind = ReferenceKind::ModelMaterial;
        let own = format!("{}/{}", parent(&asset.file.rel), line.path.text);
        let beside = line
            .path
            .text
            .split_once('/')
            .map(|(_, rest)| format!("{}/{}/{rest}", asset.category, self.base));
        let is_found =
            |rel: &String| matches!(resolve(&layers, &line.path.text, rel), Resolution::Found(_));
        let is_near = |rel: &String| resolve(&layers, &line.path.text, rel).meant().is_some();
        let places = || [Some(&own), beside.as_ref()].into_iter().flatten();
        let rel = places()
            .find(|rel| is_found(rel))
            .or_else(|| places().find(|rel| is_near(rel)))
            .unwrap_or(&own);
        self.reference(&layers, kind, from, &line.path, rel.clone())
    }

    fn reference(
        &self,
        layers: &[&'a Layer],
        kind: ReferenceKind,
        from: &'a FileFacts,
        word: &'a Word,
        rel: String,
    ) -> Reference<'a> {
        let found = Reference::to(
            layers,
            kind,
            self.base,
            from,
            Place::Span(word.span.clone()),
            &word.text,
            rel,
        );
        match found.resolution {
            Resolution::Missing if self.is_open => Reference {
                resolution: Resolution::NeedsSystem,
                ..found
            },
            _ => found,
        }
    }
}

/// The characters that wear an asset, by the printed path of each file that the asset consists of.
pub(super) fn wearers<'a>(
    base: &'a str,
    models: &[SavedModel<'a>],
    library: &Library<'a>,
    worn: &[Worn<'a>],
    references: &[Reference<'a>],
) -> BTreeMap<&'a str, Vec<SavedModel<'a>>> {
    let mut by_asset: BTreeMap<&str, Vec<SavedModel<'a>>> = BTreeMap::new();
    for model in models {
        for line in &model.model.worn {
            let listed = library
                .worn(base, &line.name.text, &line.uuid)
                .map(|asset| asset.file);
            let Some(file) = listed.or_else(|| library.unlisted(&line.name.text)) else {
                continue;
            };
            let wearers = by_asset.entry(&file.path).or_default();
            if wearers
                .last()
                .is_none_or(|other| !std::ptr::eq(other.file, model.file))
            {
                wearers.push(*model);
            }
        }
    }
    let mut by_file = by_asset.clone();
    for one in worn {
        let Some(models) = by_asset.get(one.file.path.as_str()) else {
            continue;
        };
        let named = one.references.iter().flatten().filter_map(Reference::meant);
        for file in named.chain(one.binary) {
            by_file.entry(&file.path).or_default().extend(models);
        }
    }
    // Skins, and the materials chosen for assets.
    let by_path: BTreeMap<&str, &SavedModel<'a>> = models
        .iter()
        .map(|one| (one.file.path.as_str(), one))
        .collect();
    for reference in references
        .iter()
        .filter(|one| one.kind != ReferenceKind::ModelSkeleton)
    {
        let (Some(model), Some(file)) =
            (by_path.get(reference.from.path.as_str()), reference.meant())
        else {
            continue;
        };
        by_file.entry(&file.path).or_default().push(**model);
    }
    for models in by_file.values_mut() {
        models.sort_by_key(|one| (!one.is_start, &one.file.path));
        models.dedup_by_key(|one| &one.file.path);
    }
    by_file
}
