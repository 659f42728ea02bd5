//! Macro definitions whose folder is not given, or holds none of their targets.

use super::links::{MacroLink, own_links};
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::makehuman2::{Base, TargetFolder};

/// Whether the folder is the reason that targets of a definition are missing.
pub(super) fn is_lost(base: &Base<'_>, macrodef: &Macrodef, all: &[MacroLink<'_>]) -> bool {
    let (Some(folder), Some(_)) = (&macrodef.effective_folder, &macrodef.folder) else {
        return true;
    };
    let Some(targets) = base.targets else {
        return false;
    };
    let own = own_links(all, macrodef);
    // A single name that is missing may be a slip of its own; all of several are not.
    own.iter().all(MacroLink::is_missing) && (own.len() > 1 || !holds_files(targets, folder))
}

/// Whether there is any file in the folder of a definition.
pub(super) fn holds_files(targets: TargetFolder<'_>, folder: &str) -> bool {
    targets
        .layer
        .below(&format!("{}/{}", targets.rel(), folder.trim_matches('/')))
        .next()
        .is_some()
}
