//! Assets that lie in the folder of no base mesh.

use super::OWN;
use crate::{FileFacts, Layer};
use mhlint_formats::mhclo::Entry;

/// Folders that have one for each base mesh.
const WITH_BASES: [&str; 4] = ["base", "contarget", "rigs", "target"];

/// Whether something to wear says that it is for a base mesh that `is_asked`, and its folder is
/// that of none in `layers`.
pub fn is_unfiled<'l>(
    file: &FileFacts,
    mut layers: impl Iterator<Item = &'l Layer>,
    is_asked: impl Fn(&str) -> bool,
) -> bool {
    let Some((clothes, owner)) = file
        .clothes()
        .filter(|_| !file.is_loose)
        .zip(file.base_in(OWN))
    else {
        return false;
    };
    let said = clothes.last("basemesh").map(Entry::word);
    let is_base = |layer: &Layer| {
        WITH_BASES
            .iter()
            .any(|folder| layer.has_folder(&format!("{folder}/{owner}")))
    };
    said.map_or(file.stem() == owner, is_asked) && !layers.any(is_base)
}
