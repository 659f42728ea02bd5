//! Findings on folders. Code hosts and editors know only files, so that a file in the folder stands
//! for it.

use mhlint_diag::{Finding, Folder};
use mhlint_source::Tree;

/// The folder at a printed path, if the path is that of a folder.
pub(super) fn at(path: &str, trees: &[&Tree]) -> Option<Folder> {
    let within = |tree: &&&Tree| {
        if tree.label() == path {
            Some("")
        } else {
            tree.below(path)
        }
    };
    // A zip contains folders but is not a folder.
    let is_folder =
        |tree: &Tree, rel: &str| tree.is_folder(rel) && !(rel.is_empty() && tree.pack().is_some());
    let found = trees
        .iter()
        .find_map(|tree| Some((tree, within(&tree).filter(|rel| is_folder(tree, rel))?)));
    found.map(|(tree, rel)| Folder {
        file: tree.first_file_in(rel).map(|file| tree.shown(file)),
    })
}

/// Replaces the file that stands for the folder, which is the first one in it, with a file that the
/// finding is about or relates to, if there is one.
pub(super) fn stand_in(finding: &mut Finding) {
    if finding.location.folder.is_none() {
        return;
    }
    let is_ignored = |file: &String| {
        finding
            .ignored
            .as_ref()
            .is_some_and(|ignored| ignored.files.contains(file))
    };
    let own = finding.files().iter().find(|file| !is_ignored(file));
    let related = || {
        finding
            .related
            .iter()
            .find(|one| one.location.folder.is_none())
            .map(|one| &one.path)
    };
    let better = own.or_else(related).cloned();
    if let Some(folder) = &mut finding.location.folder {
        folder.file = better.or_else(|| folder.file.take());
    }
}
