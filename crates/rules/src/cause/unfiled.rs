//! Assets of MakeHuman 2 that lie in the folder of no base mesh: no list shows them, so nothing
//! else happens to them.

use std::collections::BTreeSet;

use mhlint_diag::nearest;
use mhlint_repo::{FileFacts, Layer, Layers, Reference, ReferenceKind, Resolution};

/// Folders of assets that lists show.
pub(crate) const CATEGORIES: [&str; 13] = [
    "clothes",
    "hair",
    "eyes",
    "eyebrows",
    "eyelashes",
    "teeth",
    "tongue",
    "proxy",
    "rigs",
    "poses",
    "expressions",
    "models",
    "skins",
];

/// What other programs call the folder of targets.
pub(crate) const TARGETS_OF_OTHERS: &str = "targets";

/// Whether a file of the checked layer lies in a folder of assets, and there in the folder of none
/// of the base meshes `bases`, as far as that can be told.
pub(crate) fn is_of_no_base(layers: Layers<'_>, bases: &BTreeSet<&str>, file: &FileFacts) -> bool {
    let mut parts = file.rel.split('/');
    let Some(category) = parts.next().filter(|first| CATEGORIES.contains(first)) else {
        return false;
    };
    let Some(folder) = parts.next().filter(|_| parts.next().is_some()) else {
        return true;
    };
    // Without the system data it may be one of its base meshes, unless it is the asset's own
    // folder.
    let can_tell = layers.system.is_some() || file.stem() == folder;
    // A folder that several categories have is that of a base mesh elsewhere.
    let is_elsewhere = || {
        let mut others = CATEGORIES.iter().filter(|other| **other != category);
        others.any(|other| {
            layers
                .checked
                .below(&format!("{other}/{folder}"))
                .next()
                .is_some()
        })
    };
    can_tell && !bases.is_empty() && !bases.contains(folder) && !is_elsewhere()
}

/// The folder at the top that has the name of another one by a slip and holds the skeleton that
/// `base.json` names: then it is the skeleton that is missing, and nothing else is said of the
/// folder.
pub(crate) fn renamed_rigs<'l>(layer: &'l Layer, reference: &Reference<'_>) -> Option<&'l str> {
    let is_lost = matches!(reference.resolution, Resolution::Missing)
        && reference.kind == ReferenceKind::PoseSkeleton;
    let below = reference.rel.strip_prefix("rigs").filter(|_| is_lost)?;
    let mut folders = layer.tops_with(below).filter(|folder| *folder != "rigs");
    folders.find(|folder| nearest(folder, CATEGORIES) == Some("rigs"))
}
