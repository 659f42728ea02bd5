//! The archive of an asset that cannot be loaded, in words.

use super::Sort;
use super::words::{missing, not_zip, of_member, of_mesh};
use mhlint_diag::{Application::Makehuman2, Case, Level};
use mhlint_formats::mhbin::MeshFault;
use mhlint_formats::npz::ArchiveFault;
use mhlint_formats::packed::asset::{Packed, PackedAsset, PackedFault};
use mhlint_repo::{FileFacts, View};

const NOT_ZIP: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes at start with `BadZipFile` while scanning the assets; the next start has no assets \
        at all",
)];
const NO_ASSET: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes at start with `KeyError` while scanning the assets; the next start has no assets at \
        all",
)];
const NO_HEAD: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes at start with `TypeError` while scanning the assets; the next start has no assets at \
        all",
)];
const REFUSED: Case = &[(
    Makehuman2,
    Level::Error,
    "refuses the asset with a message: it cannot be put on",
)];
const STOPS: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes when the asset is put on; models that wear it load only in part",
)];

/// What is wrong with an archive that the library scans, and what comes of it.
pub(super) fn fault(view: &View<'_>, file: &FileFacts) -> Option<(Sort, String, Case)> {
    let is_scanned = file.rel.ends_with(".mhbin") && (view.layout().scans)(&file.rel);
    match file.packed().filter(|_| is_scanned)? {
        // `file-empty` has it.
        Packed::Unopened(ArchiveFault::Empty) => None,
        Packed::Unopened(ArchiveFault::NotZip(reason)) => {
            Some((Sort::Malformed, not_zip(reason), NOT_ZIP))
        }
        Packed::Other | Packed::Proxy(_) | Packed::Mesh(_) => {
            let message =
                "member `asset` is missing: this is not the archive of an asset".to_owned();
            Some((Sort::MissingMember, message, NO_ASSET))
        }
        Packed::Asset(asset) => of_asset(asset),
    }
}

fn of_asset(asset: &PackedAsset) -> Option<(Sort, String, Case)> {
    let absent = asset.faults.iter().flat_map(|fault| match fault {
        PackedFault::Missing(name) => vec![*name],
        PackedFault::Mesh(MeshFault::Missing(names)) => names.clone(),
        _ => Vec::new(),
    });
    let absent: Vec<&str> = absent.collect();
    Some(match asset.faults.first()? {
        PackedFault::Asset(fault) => (
            Sort::of(fault),
            format!("member `asset` {}", of_member(fault)),
            NO_HEAD,
        ),
        _ if !absent.is_empty() => (Sort::MissingMember, missing(&absent), REFUSED),
        PackedFault::Member(name, fault) => (
            Sort::of(fault),
            format!("member `{name}` {}", of_member(fault)),
            STOPS,
        ),
        PackedFault::Mesh(fault) => {
            let (sort, message, _) = of_mesh(fault)?;
            (sort, message, STOPS)
        }
        PackedFault::Missing(name) => (Sort::MissingMember, missing(&[name]), REFUSED),
    })
}

/// What to do about it.
pub(super) fn help(view: &View<'_>, file: &FileFacts) -> &'static str {
    if view.layers().checked.text_of_archive(&file.rel).is_some() {
        "if the text (`.mhclo` or `.proxy`) and its mesh are up to date, delete the archive: \
            MakeHuman 2 builds it again from them"
    } else {
        "restore the archive, or move it out of the folder"
    }
}
