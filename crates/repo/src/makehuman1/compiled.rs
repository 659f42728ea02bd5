//! Assets that are nothing but their archive (`.mhpxy`), and what archives name
//! (`docs/loaders/makehuman1/compiled-clothes.md#when-it-is-read`,
//! `docs/loaders/makehuman1/folders.md#search-lists`).

use super::search::Search;
use super::view::{OWN, beside_mesh};
use crate::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution, Worn};
use mhlint_diag::Place;
use mhlint_discover::archive_library_of;
use mhlint_formats::asset_mesh::KeptFaces;
use mhlint_formats::mhclo;
use mhlint_formats::packed::asset::Packed;
use mhlint_formats::packed::proxy::{PackedProxy, USUAL_POLE};
use mhlint_formats::python_int;

/// The assets of a layer that have no text, also those whose archive cannot be read.
pub(super) fn lone<'a>(layers: Layers<'a>, layer: &'a Layer) -> impl Iterator<Item = Worn<'a>> {
    let archives = layer
        .files
        .values()
        .filter(move |file| is_lone(layer, file));
    archives.filter_map(move |file| {
        let references =
            Packed::proxy_of(file.packed()).map(|proxy| references(layers, layer, file, proxy));
        let base = file.base_in(OWN)?;
        Some(Worn {
            file,
            base,
            binary: None,
            references,
            packed_mesh: None,
            drops_bytes: true,
        })
    })
}

/// Whether a library lists the archive of something worn in place of a text that is not there.
fn is_lone(layer: &Layer, file: &FileFacts) -> bool {
    archive_library_of(&file.rel).is_some() && layer.text_of_archive(&file.rel).is_none()
}

/// What the archive beside a text names, if it can be loaded.
pub fn named_by_archive<'a>(layers: Layers<'a>, file: &'a FileFacts) -> Option<Vec<Reference<'a>>> {
    let proxy = Packed::proxy_of(file.packed())?;
    let layer = layers.strongest_first().find(|layer| {
        layer
            .file(&file.rel)
            .is_some_and(|own| std::ptr::eq(own, file))
    });
    Some(references(layers, layer?, file, proxy))
}

/// What an archive names, as the program looks for it: from the folder of the archive, then from
/// the data folders.
fn references<'a>(
    layers: Layers<'a>,
    layer: &'a Layer,
    file: &'a FileFacts,
    proxy: &'a PackedProxy,
) -> Vec<Reference<'a>> {
    let Some(base) = file.base_in(OWN) else {
        return Vec::new();
    };
    let search = Search {
        layers,
        layer,
        file,
    };
    let reference = |kind, text: &'a str, (rel, resolution)| {
        let (from, owner, place) = (file, file.stem(), Place::File);
        Reference {
            kind,
            base,
            from,
            place,
            text,
            owner,
            folder_at_fault: None,
            rel,
            resolution,
        }
    };
    let [mesh, material, weights] = &proxy.files;
    let named =
        |kind, text: &'a str| (!text.is_empty()).then(|| reference(kind, text, search.find(text)));
    let mesh = reference(ReferenceKind::AssetMesh, mesh, find_mesh(&search, mesh));
    let others = [
        named(ReferenceKind::AssetWeights, weights),
        named(ReferenceKind::AssetMaterial, material),
    ];
    [Some(mesh)].into_iter().chain(others).flatten().collect()
}

/// A mesh may be there as an archive alone, and is found by that.
fn find_mesh<'a>(search: &Search<'a>, text: &str) -> (String, Resolution<'a>) {
    let (stem, extension) = text.rsplit_once('.').unwrap_or((text, "obj"));
    let (rel, packed) = search.find(&format!("{stem}.npz"));
    match packed {
        Resolution::Found(_) => {
            let rel = format!("{}.{extension}", rel.strip_suffix(".npz").unwrap_or(&rel));
            let text = search
                .layers
                .strongest_first()
                .find_map(|layer| layer.file(&rel));
            (rel, text.map_or(packed, Resolution::Found))
        }
        _ => search.find(text),
    }
}

/// How many faces of a vertex the program makes room for: twice what the text says, or what the
/// archive says. Which of the two is read depends on their dates.
pub(super) fn asked_faces(worn: &Worn<'_>) -> Vec<u64> {
    let archive = worn
        .packed_proxy()
        .or_else(|| Packed::proxy_of(worn.binary?.packed()));
    let entry = worn
        .clothes()
        .and_then(|clothes| mhclo::makehuman1::READER.of(clothes).last("max_pole"));
    let said = entry.and_then(|entry| u64::try_from(python_int(entry.word().as_bytes())?).ok());
    let of_text = worn
        .clothes()
        .map(|_| said.unwrap_or(USUAL_POLE).saturating_mul(2));
    archive
        .map(|proxy| proxy.max_pole)
        .into_iter()
        .chain(of_text)
        .collect()
}

/// The archive of a mesh that has less room than something worn asks for, with that: the program
/// then looks for the OBJ.
pub fn narrow_mesh<'a>(
    layers: Layers<'a>,
    worn: &Worn<'a>,
) -> Option<(&'a FileFacts, KeptFaces, u64)> {
    let (file, mesh) = beside_mesh(layers, worn).filter(|_| worn.packed_mesh.is_none())?;
    Some((file, mesh.kept_faces?, asked_faces(worn).into_iter().min()?))
}
