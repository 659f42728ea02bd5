//! Assets that a body wears, with the files that they name.

use super::{FileFacts, Layer, Reference, ReferenceKind, parent};
use crate::diag::{Application, Place};
use crate::discover::Kind;
use crate::formats::mhclo::Entry;

/// An asset that a body wears.
#[derive(Debug)]
pub(crate) struct Worn<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The body that it is for.
    pub base: &'a str,
    /// What it names, with what is there; `None` where that cannot be read.
    pub references: Option<Vec<Reference<'a>>>,
}

impl<'a> Worn<'a> {
    /// The texts of assets of a layer, with the body that each is for.
    pub(super) fn all(layer: &'a Layer, application: Application) -> impl Iterator<Item = (&'a FileFacts, &'a str)> {
        let files = layer.files.values().filter(move |file| file.kind_in(application) == Kind::Clothes);
        files.filter_map(move |file| Some((file, file.base_in(application)?)))
    }

    /// An asset whose names lead on from its own folder, that of its weights from the folder of its mesh where these are
    /// looked for there. Of several names the last counts.
    pub(super) fn of(
        layer: &'a Layer,
        file: &'a FileFacts,
        base: &'a str,
        counts: fn(&Entry) -> bool,
        weights_beside_mesh: bool,
    ) -> Self {
        let own = parent(&file.rel);
        let references = file.clothes().map(|clothes| {
            let named = |keyword, kind, folder: &str| {
                let entry = clothes.all(keyword).rev().find(|entry| counts(entry))?;
                let (place, word) = (Place::Span(entry.word_span()), entry.word());
                Some(Reference::to(&[layer], kind, base, file, place, word, format!("{folder}/{word}")))
            };
            let mesh = named("obj_file", ReferenceKind::AssetMesh, own);
            let folder = mesh.as_ref().filter(|_| weights_beside_mesh).map_or(own, |mesh| parent(&mesh.rel));
            let weights = named("vertexboneweights_file", ReferenceKind::AssetWeights, folder);
            let material = named("material", ReferenceKind::AssetMaterial, own);
            [mesh, weights, material].into_iter().flatten().collect()
        });
        Self { file, base, references }
    }

    /// The weights that it names.
    pub(super) fn weights(&self) -> impl Iterator<Item = &'a FileFacts> {
        let references = self.references.iter().flatten().filter(|one| one.kind == ReferenceKind::AssetWeights);
        references.filter_map(Reference::meant)
    }
}
