//! Assets that a body wears, with the files that they name.

use super::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution};
use mhlint_diag::{Application, Place};
use mhlint_discover::Kind;
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::mhclo::{self, Clothes, Reader};
use mhlint_formats::packed::asset::Packed;
use mhlint_formats::packed::proxy::PackedProxy;
use mhlint_source::{Guess, normalized, parent};

/// An asset that a body wears.
#[derive(Debug)]
pub struct Worn<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The body that it is for.
    pub base: &'a str,
    /// The archive beside it, which MakeHuman 1 and 2 read in its place unless the text is newer.
    pub binary: Option<&'a FileFacts>,
    /// What it names, with what is there; `None` where that cannot be read.
    pub references: Option<Vec<Reference<'a>>>,
    /// The archive of its mesh, which MakeHuman 1 reads in the place of the OBJ.
    pub packed_mesh: Option<(&'a FileFacts, &'a AssetMesh)>,
    /// Whether the application drops bytes that are not UTF-8 and reads the rest.
    pub(super) drops_bytes: bool,
}

/// What an archive names.
fn packed_references<'a>(
    layer: &'a Layer,
    file: &'a FileFacts,
    base: &'a str,
) -> Option<Vec<Reference<'a>>> {
    let Packed::Asset(asset) = file.packed()? else {
        return None;
    };
    let own = parent(&file.rel);
    let [material, weights] = &asset.files;
    let named = |text: &'a str, kind| {
        let rel = || format!("{own}/{text}");
        (!text.is_empty())
            .then(|| Reference::to(&[layer], kind, base, file, Place::File, text, rel()))
    };
    let references = [
        named(weights, ReferenceKind::AssetWeights),
        named(material, ReferenceKind::AssetMaterial),
    ];
    Some(references.into_iter().flatten().collect())
}

/// How an application reads the text of an asset.
pub const fn worn_reader(application: Application) -> &'static Reader {
    match application {
        Application::Makehuman1 => &mhclo::makehuman1::READER,
        Application::Makehuman2 => &mhclo::makehuman2::READER,
        Application::Mpfb => &mhclo::mpfb::READER,
    }
}

impl<'a> Worn<'a> {
    /// The texts of assets of a layer, with the body that each is for.
    pub(super) fn all(
        layer: &'a Layer,
        application: Application,
    ) -> impl Iterator<Item = (&'a FileFacts, &'a str)> {
        let files = layer
            .files
            .values()
            .filter(move |file| file.kind_in(application) == Kind::Clothes);
        files.filter_map(move |file| Some((file, file.base_in(application)?)))
    }

    /// An asset whose names lead on from its own folder, that of its weights from the folder of its
    /// mesh where these are looked for there. Of several names the last counts.
    pub(super) fn of(
        layer: &'a Layer,
        file: &'a FileFacts,
        base: &'a str,
        reader: &'static Reader,
        weights_beside_mesh: bool,
    ) -> Self {
        let own = parent(&file.rel);
        let references = file.clothes().map(|clothes| {
            let named = |keyword, kind, folder: &str| {
                let entry = reader.of(clothes).last(keyword)?;
                let (place, word) = (Place::Span(entry.word_span()), entry.word());
                Some(Reference::to(
                    &[layer],
                    kind,
                    base,
                    file,
                    place,
                    word,
                    format!("{folder}/{word}"),
                ))
            };
            let mesh = named("obj_file", ReferenceKind::AssetMesh, own);
            let folder = mesh
                .as_ref()
                .filter(|_| weights_beside_mesh)
                .map_or(own, |mesh| parent(&mesh.rel));
            let weights = named(
                "vertexboneweights_file",
                ReferenceKind::AssetWeights,
                folder,
            );
            let material = named("material", ReferenceKind::AssetMaterial, own);
            [mesh, weights, material].into_iter().flatten().collect()
        });
        let references = references.or_else(|| packed_references(layer, file, base));
        let binary = layer.file(&format!("{own}/{}.mhbin", file.stem()));
        Self {
            file,
            base,
            binary,
            references,
            packed_mesh: None,
            drops_bytes: false,
        }
    }

    /// The same, where a loose asset may have been made beside those of the system: what it names
    /// there, outside of its own folder, is not missing. In which library it was made nobody knows.
    pub(super) fn beside_system(mut self, layers: Layers<'a>) -> Self {
        let is_beside = |one: &&mut Reference<'_>| {
            one.text.starts_with("../") && matches!(one.resolution, Resolution::Missing)
        };
        let references = self
            .references
            .iter_mut()
            .flatten()
            .filter(|_| self.file.is_loose);
        for reference in references.filter(is_beside) {
            let below =
                normalized(&reference.rel).and_then(|rel| Some(rel.split_once('/')?.1.to_owned()));
            let there = |system: &'a Layer| {
                let libraries = system.folders.iter().filter(|folder| !folder.contains('/'));
                let below = below.as_deref()?;
                libraries
                    .into_iter()
                    .find_map(|library| system.file(&format!("{library}/{below}")))
            };
            reference.resolution = match layers.system.map(there) {
                Some(Some(file)) => Resolution::Found(file),
                Some(None) => Resolution::Missing,
                None => Resolution::NeedsSystem,
            };
        }
        self
    }

    /// What is in its text, if that can be relied on.
    pub fn clothes(&self) -> Option<&'a Clothes> {
        let encoding = &self.file.encoding;
        let is_text = encoding.invalid_utf8_at.is_none()
            || self.drops_bytes && encoding.guess == Some(Guess::SingleByte);
        self.file
            .clothes()
            .filter(|_| is_text && !encoding.blank && !encoding.only_comments)
    }

    /// What is in the archive of MakeHuman 1 that is all there is of it, if that can be loaded.
    pub fn packed_proxy(&self) -> Option<&'a PackedProxy> {
        Packed::proxy_of(self.file.packed())
    }

    /// The last name of a kind in it.
    pub fn reference(&self, kind: ReferenceKind) -> Option<&Reference<'a>> {
        self.references
            .as_ref()?
            .iter()
            .find(|reference| reference.kind == kind)
    }

    /// Its mesh, if that could be read at all.
    pub fn mesh(&self) -> Option<(&'a FileFacts, &'a AssetMesh)> {
        if self.packed_mesh.is_some() {
            return self.packed_mesh;
        }
        let file = self.reference(ReferenceKind::AssetMesh)?.meant()?;
        Some((
            file,
            file.asset_mesh()
                .filter(|_| file.encoding.invalid_utf8_at.is_none())?,
        ))
    }

    /// Whether it stands for the skin of the body.
    pub fn is_topology(&self) -> bool {
        self.file.rel.starts_with("proxy/") || self.file.rel.starts_with("proxymeshes/")
    }

    /// The weights that it names.
    pub(super) fn weights(&self) -> impl Iterator<Item = &'a FileFacts> {
        let references = self
            .references
            .iter()
            .flatten()
            .filter(|one| one.kind == ReferenceKind::AssetWeights);
        references.filter_map(Reference::meant)
    }
}
