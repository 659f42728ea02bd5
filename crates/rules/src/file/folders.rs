//! Folders with other capitals than those that are listed.

use std::collections::BTreeSet;

use super::super::{Rule, and_more, counted};
use mhlint_diag::{Evidence, Finding, grouped};
use mhlint_repo::{MisnamedFolder, View};
use mhlint_source::file_name;

/// One finding for each name, but for folders that a finding on a name in a file names already.
pub(super) fn findings(rule: &Rule, view: &View<'_>, told: &BTreeSet<String>) -> Vec<Finding> {
    let name = |folder: &MisnamedFolder| file_name(&folder.rel).to_owned();
    let by_name = grouped(
        view.misnamed_folders()
            .into_iter()
            .map(|folder| (name(&folder), folder)),
    );
    let is_new =
        |folders: &&Vec<MisnamedFolder>| !folders.iter().any(|folder| told.contains(&folder.rel));
    by_name
        .values()
        .filter(is_new)
        .filter_map(|folders| finding(rule, view, folders))
        .collect()
}

fn finding(rule: &Rule, view: &View<'_>, folders: &[MisnamedFolder]) -> Option<Finding> {
    let first = folders.first()?;
    let files: usize = folders.iter().map(|folder| folder.files).sum();
    let right = file_name(&first.right);
    let more = and_more(folders.len(), "folder");
    let message = format!("`{}` must be named `{}`{more}", first.rel, first.right);
    let effect = format!(
        "on Linux, does not read the folder and its {}",
        counted(files, "file")
    );
    let finding = rule
        .in_layer(view.layers().checked, &first.rel, message)
        .key("folder");
    let evidence = Evidence::of_cases(folders.iter().map(|folder| &folder.rel));
    Some(
        finding
            .effect_in(view.application(), effect)
            .help(format!("rename it to `{right}`"))
            .evidence(evidence),
    )
}
