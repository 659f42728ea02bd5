//! Targets of a base mesh that is nowhere.

use std::collections::BTreeSet;

use super::super::Rule;
use mhlint_diag::{Finding, Level};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

/// One finding for the folder of the targets.
pub(super) fn finding(rule: &Rule, view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let checked = view.layers.checked;
    let folders = ["contarget", "target"].map(|folder| (folder, format!("{folder}/{}", base.name)));
    // A loose file lies in no folder of a base: that its base is not known is among what was not
    // checked.
    let is_in = |folder: &&(_, String)| checked.below(&folder.1).any(|file| !file.is_loose);
    let (top, folder) = folders.iter().find(is_in)?;
    let message = format!(
        "base `{}` does not exist: base.json and the mesh are missing",
        base.name
    );
    let finding = rule
        .in_layer(checked, folder, message)
        .key("base")
        .level(Level::Warning);
    let help = meant(view, checked.below(folder)).map_or_else(
        || {
            "rename the folder to an existing base; if the system data has the base, pass it with \
            `--system`"
                .to_owned()
        },
        |other| {
            let is_direct = |file: &FileFacts| {
                file.rel
                    .rsplit_once('/')
                    .is_some_and(|(above, _)| above == folder)
            };
            // Pairs of targets outside of a group stop the program.
            if checked
                .below(folder)
                .any(|file| file.target().is_some() && is_direct(file))
            {
                let name = base.name;
                format!(
                    "move the folder to `{top}/{other}/{name}`, so that it is a group of \
                    targets of `{other}`"
                )
            } else {
                format!(
                    "move the content of the folder to `{top}/{other}`, for which the targets \
                    are made"
                )
            }
        },
    );
    Some(finding.effect("never loads these targets").help(help))
}

/// The base mesh that the headers of targets name, if they agree and it exists.
fn meant<'a>(view: &View<'a>, files: impl Iterator<Item = &'a FileFacts>) -> Option<&'a str> {
    let targets = files.filter_map(FileFacts::target);
    let named: BTreeSet<String> = targets
        .filter_map(|target| Some(target.basemesh.as_ref()?.1.to_ascii_lowercase()))
        .collect();
    let name = named.first().filter(|_| named.len() == 1)?;
    let other = view.base_ignoring_case(name)?;
    (!view.is_nowhere(other.name)).then_some(other.name)
}
