//! The archives of assets (`.mhbin`, `.mhpxy`) with the texts that they were made from.

use std::collections::BTreeMap;

use super::{Text, texts};
use mhlint_formats::mhclo::RowFacts;
use mhlint_formats::packed::asset::{Mask, Packed, PackedAsset};
use mhlint_formats::target::MeshSize;
use mhlint_repo::{Body, FileFacts, ReferenceKind, Resolution, Worn};

/// The archive of an asset, of the checked layer.
#[derive(Clone, Copy)]
pub(super) struct Archive<'b, 'v> {
    pub(super) worn: &'b Worn<'v>,
    pub(super) file: &'v FileFacts,
    pub(super) asset: &'v PackedAsset,
    /// The text that it was made from.
    pub(super) text: Option<Text<'b, 'v>>,
}

/// The archives of assets that can be loaded.
pub(super) fn archives<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Archive<'b, 'v>> {
    let beside = texts(body).filter_map(|text| Some((text.worn.binary?.path.as_str(), text)));
    let beside: BTreeMap<&str, Text<'b, 'v>> = beside.collect();
    let own = body
        .worn
        .iter()
        .filter(|worn| body.layers.is_checked(worn.file));
    own.filter_map(move |worn| match worn.file.packed()? {
        Packed::Asset(asset) if asset.faults.is_empty() => {
            let text = beside.get(worn.file.path.as_str()).copied();
            Some(Archive {
                worn,
                file: worn.file,
                asset,
                text,
            })
        }
        _ => None,
    })
}

/// An archive that is all there is of an asset, of the checked layer.
#[derive(Clone, Copy)]
pub(super) struct Lone<'b, 'v> {
    pub(super) worn: &'b Worn<'v>,
    pub(super) file: &'v FileFacts,
    pub(super) rows: &'v RowFacts,
    pub(super) mask: Option<&'v Mask>,
}

/// The archives that are all there is of an asset, of MakeHuman 2 and 1: beside a text the fault is
/// told there, or that the two differ.
pub(super) fn lone_archives<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Lone<'b, 'v>> {
    let of_makehuman2 = archives(body)
        .filter(|archive| archive.text.is_none())
        .map(|archive| {
            let Archive {
                worn, file, asset, ..
            } = archive;
            Lone {
                worn,
                file,
                rows: &asset.rows,
                mask: asset.mask.as_ref(),
            }
        });
    let own = body
        .worn
        .iter()
        .filter(|worn| body.layers.is_checked(worn.file));
    let of_makehuman1 = own.filter_map(|worn| {
        let proxy = worn.packed_proxy()?;
        Some(Lone {
            worn,
            file: worn.file,
            rows: &proxy.rows,
            mask: proxy.mask.as_ref(),
        })
    });
    of_makehuman2.chain(of_makehuman1)
}

impl Lone<'_, '_> {
    /// Whether its mesh is not where it was packed (`proxy-missing-mesh`): then nothing else is.
    pub(super) fn has_moved(&self) -> bool {
        let mesh = self.worn.reference(ReferenceKind::AssetMesh);
        mesh.is_some_and(|mesh| matches!(mesh.resolution, Resolution::Missing))
    }
}

impl Archive<'_, '_> {
    /// The base mesh, if the rows were counted against it.
    pub(super) fn size_of_base(&self, body: &Body<'_>) -> Option<MeshSize> {
        let size = body.whole_mesh()?.size();
        (self.asset.rows.mesh == Some(size)).then_some(size)
    }
}

/// What to do about an archive, with the text beside it or without.
pub(super) const fn rebuild(has_text: bool) -> &'static str {
    if has_text {
        "if the text (`.mhclo` or `.proxy`) and its mesh are up to date, delete the `.mhbin`: \
            MakeHuman 2 builds it again from them"
    } else {
        "export the asset again for this base mesh, or remove the `.mhbin`"
    }
}
