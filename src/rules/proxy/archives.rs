//! The archives of assets (`.mhbin`) with the texts that they were made from.

use std::collections::BTreeMap;

use super::{Text, texts};
use crate::formats::mhbin_asset::{Packed, PackedAsset};
use crate::formats::target::MeshSize;
use crate::repo::{Body, FileFacts, Worn};

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
    let own = body.worn.iter().filter(|worn| body.layers.is_checked(worn.file));
    own.filter_map(move |worn| match worn.file.packed()? {
        Packed::Asset(asset) if asset.faults.is_empty() => {
            let text = beside.get(worn.file.path.as_str()).copied();
            Some(Archive { worn, file: worn.file, asset, text })
        }
        _ => None,
    })
}

/// Those that are all there is of an asset: beside a text the fault is told there, or that the two differ.
pub(super) fn lone_archives<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = Archive<'b, 'v>> {
    archives(body).filter(|archive| archive.text.is_none())
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
        "if the text (`.mhclo` or `.proxy`) and its mesh are up to date, delete the `.mhbin`: MakeHuman 2 builds it again from them"
    } else {
        "export the asset again for this base mesh, or remove the `.mhbin`"
    }
}
