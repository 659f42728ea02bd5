//! Who uses a target: a target that nothing uses is told as such.
//!
//! Gets a base with its references, returns the targets that the application reads and nobody uses.
//! Says nothing where the files that would use them are missing, broken or of another layer.

use std::collections::{BTreeMap, BTreeSet};

use super::overlay::is_damaged;
use crate::repo::{Base, FileFacts, ReferenceKind, Repository, TargetFolder, is_beneath};

/// How a target is used, by printed path; a macro outweighs a slider because it is applied at start.
pub(in crate::rules) fn users<'a>(repository: &'a Repository<'_>) -> BTreeMap<&'a str, ReferenceKind> {
    let mut users = BTreeMap::new();
    for reference in repository.references.iter().filter(|reference| reference.kind.is_target()) {
        if let Some(file) = reference.meant() {
            let known = users.entry(file.path.as_str()).or_insert(reference.kind);
            *known = reference.kind.min(*known);
        }
    }
    add_links(repository, &mut users);
    users
}

/// Who uses a file through a link uses the file, and the other way round.
fn add_links<'a>(repository: &'a Repository<'_>, users: &mut BTreeMap<&'a str, ReferenceKind>) {
    let linked = |link: &'a FileFacts| Some([link, repository.judged.file(link.link_to.as_deref()?)?]);
    for pair in repository.judged.files.values().filter_map(linked) {
        if let Some(kind) = pair.iter().filter_map(|file| users.get(file.path.as_str())).min().copied() {
            users.extend(pair.map(|file| (file.path.as_str(), kind)));
        }
    }
}

/// Paths of all unused targets of all bases.
pub(in crate::rules) fn unused_paths<'a>(repository: &Repository<'a>) -> BTreeSet<&'a str> {
    let files = repository.bases.iter().flat_map(|base| unused(repository, base));
    files.map(|file| file.path.as_str()).collect()
}

/// Targets that the application reads for the base and that nothing uses: those of the folder in use,
/// and user targets too deep to become sliders.
pub(in crate::rules) fn unused<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Vec<&'a FileFacts> {
    let mut unused = unused_user_targets(repository, base);
    if let Some(folder) = base.targets.filter(|folder| can_tell(base, *folder)) {
        unused.extend(unused_targets(repository, base, folder));
    }
    unused
}

/// Targets of the folder in use that nothing uses.
fn unused_targets<'a>(repository: &Repository<'a>, base: &Base<'a>, folder: TargetFolder<'a>) -> Vec<&'a FileFacts> {
    let users = users(repository);
    let is_used = |file: &&FileFacts| users.contains_key(file.path.as_str());
    let used_folders: BTreeSet<&str> = folder.targets().filter(is_used).map(|file| parent(&file.rel)).collect();
    // A base may do without macro.json. Then a folder of which nothing is used may wait for one.
    let has_macros = base.macro_file().is_some();
    let is_judged = |file: &&FileFacts| has_macros || used_folders.contains(parent(&file.rel));
    // What a slider uses that is reported for itself is not known, or known under a misspelt key.
    let is_explained = |file: &&FileFacts| {
        let Some(name) = folder.name_of(file) else { return false };
        base.means_target(name) || base.has_unreadable_sliders() && !is_in_macro_folder(base, name)
    };
    folder.targets().filter(|file| !is_used(file)).filter(is_judged).filter(|file| !is_explained(file)).collect()
}

fn unused_user_targets<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Vec<&'a FileFacts> {
    let Some(folder) = base.user_targets else { return Vec::new() };
    let users = users(repository);
    let is_deep = |file: &&FileFacts| folder.name_of(file).is_some_and(|name| name.matches('/').count() > 1);
    folder.targets().filter(is_deep).filter(|file| !users.contains_key(file.path.as_str())).collect()
}

/// Whether sliders and macros that are meant for the folder are there and could be read.
fn can_tell(base: &Base<'_>, folder: TargetFolder<'_>) -> bool {
    let own_sliders = folder.layer.file(&format!("{}/modelling.json", folder.rel()));
    let sliders_in_use = base.modelling.winner().map(|(file, _)| file);
    !is_damaged(&base.modelling)
        && !is_damaged(&base.macros)
        && matches!((own_sliders, sliders_in_use), (Some(own), Some(used)) if std::ptr::eq(own, used))
}

/// Whether a target lies in a folder of a macro definition; those have a rule of their own.
pub(in crate::rules) fn is_in_macro_folder(base: &Base<'_>, name: &str) -> bool {
    let macrodefs = base.macro_file().map(|(_, file)| file.macrodefs.as_slice()).unwrap_or_default();
    let mut folders = macrodefs.iter().filter_map(|macrodef| macrodef.effective_folder.as_deref());
    folders.any(|folder| is_beneath(folder, name) && !is_beneath(folder, parent(name)))
}

/// Whether something refers to `rel` and does not find it: then the missing file is the fault to name.
pub(in crate::rules) fn is_missed(repository: &Repository<'_>, base: &Base<'_>, rel: &str) -> bool {
    repository.references_of(base).any(|reference| reference.kind.is_target() && reference.rel == rel)
}

/// The folder of a path, empty at the top.
pub(in crate::rules) fn parent(rel: &str) -> &str {
    rel.rsplit_once('/').map_or("", |(folder, _)| folder)
}
