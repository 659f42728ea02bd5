//! Assets that a body wears, with the files that they name.

use super::{FileFacts, Layer, Reference, ReferenceKind, parent};
use crate::diag::{Application, Place};
use crate::discover::Kind;
use crate::formats::mhclo::{Name, Named};

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
        counts: fn(&Name) -> bool,
        weights_beside_mesh: bool,
    ) -> Self {
        let own = parent(&file.rel);
        let references = file.asset_names().map(|names| {
            let named = |what, kind, folder: &str| {
                let name = names.iter().rev().filter(|name| counts(name)).find(|name| name.what == what)?;
                let (place, rel) = (Place::Span(name.span.clone()), format!("{folder}/{}", name.word));
                Some(Reference::to(&[layer], kind, base, file, place, &name.word, rel))
            };
            let mesh = named(Named::Mesh, ReferenceKind::AssetMesh, own);
            let folder = mesh.as_ref().filter(|_| weights_beside_mesh).map_or(own, |mesh| parent(&mesh.rel));
            let weights = named(Named::Weights, ReferenceKind::AssetWeights, folder);
            let material = named(Named::Material, ReferenceKind::AssetMaterial, own);
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
