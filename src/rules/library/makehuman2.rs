//! Folders of MakeHuman 2 that no list looks into.

use std::collections::BTreeSet;

use super::super::{Rule, counted, did_you_mean};
use crate::diag::{Evidence, Finding, Place, nearest};
use crate::repo::FileFacts;
use crate::repo::makehuman2::View;

/// Folders of assets that lists show.
pub(super) const CATEGORIES: [&str; 13] = [
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

/// What lies in a folder that is no category but looks like one: by its name, or because it is sorted by base mesh and has
/// assets that are nowhere else. A name with other capitals has a finding of its own.
pub(super) fn unread(
    rule: &Rule,
    view: &View<'_>,
    folder: &str,
    files: &[&FileFacts],
    bases: &BTreeSet<&str>,
) -> Option<Finding> {
    let (first, near) = (files.first()?, nearest(folder, CATEGORIES));
    let has_base = |file: &&FileFacts| file.rel.split('/').nth(1).is_some_and(|base| bases.contains(base));
    let is_meant = near.is_some() || files.iter().any(|file| is_lost(view, file));
    if near.is_some_and(|near| near.eq_ignore_ascii_case(folder)) || !is_meant || !files.iter().all(has_base) {
        return None;
    }
    let message = format!("folder `{folder}` is not read ({})", counted(files.len(), "asset"));
    let parts = files.iter().map(|file| (file.shown(), &file.path));
    let finding = rule.at(first, Place::File, message).key(format!("folder {folder}")).parts_in(parts);
    let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
    Some(finding.help(did_you_mean(near, "rename it to the kind of its assets, such as `clothes`, `hair` or `eyes`")))
}

/// Whether a worn asset is listed nowhere under its name.
fn is_lost(view: &View<'_>, file: &FileFacts) -> bool {
    let name = file.clothes().and_then(|clothes| clothes.scanned.name.as_ref());
    let base = view.library.bases().into_iter().find(|base| file.rel.split('/').nth(1) == Some(base));
    name.is_some_and(|name| base.is_none_or(|base| view.library.named(base, &name.text).next().is_none()))
}
