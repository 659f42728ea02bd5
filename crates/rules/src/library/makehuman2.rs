//! Folders of MakeHuman 2 that no list looks into.

use std::collections::BTreeSet;

use super::super::cause::unfiled::{CATEGORIES, TARGETS_OF_OTHERS, renamed_rigs};
use super::super::{Rule, counted, did_you_mean};
use mhlint_diag::{Application, Evidence, Finding, Place, nearest};
use mhlint_discover::extension;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::View;

/// What lies in a folder that is no category but looks like one: by its name, or because it is
/// sorted by base mesh and has assets that are nowhere else. A name with other capitals has a
/// finding of its own.
pub(super) fn unread(
    rule: &Rule,
    view: &View<'_>,
    listed: &Listed<'_>,
    folder: &str,
    files: &[&FileFacts],
    bases: &BTreeSet<&str>,
) -> Option<Finding> {
    let (first, near) = (files.first()?, nearest(folder, CATEGORIES));
    let has_base = |file: &&FileFacts| {
        file.rel
            .split('/')
            .nth(1)
            .is_some_and(|base| bases.contains(base))
    };
    // Beside the libraries of a pack it may wait there on purpose.
    let is_at_top = |file: &&FileFacts| {
        is_directly_in(file) && !view.layers.checked.is_pack_of(Application::Makehuman2)
    };
    let is_meant = near.is_some() || files.iter().any(|file| is_lost(view, listed, file));
    if near.is_some_and(|near| near.eq_ignore_ascii_case(folder))
        || near == Some("rigs") && listed.renamed_rigs.contains(folder)
        || !is_meant
        || !files.iter().all(|file| has_base(file) || is_at_top(file))
    {
        return None;
    }
    let message = format!(
        "folder `{folder}` is not read ({})",
        counted(files.len(), "asset")
    );
    let is_of_asset = near.is_none() && files.iter().all(is_at_top);
    let parts = files.iter().map(|file| (file.shown(), &file.path));
    let finding = rule
        .at(first, Place::File, message)
        .key(format!("folder {folder}"))
        .parts_in(parts);
    let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
    let base = bases
        .first()
        .filter(|_| bases.len() == 1)
        .copied()
        .unwrap_or("<base>");
    if is_of_asset {
        return Some(finding.help(format!(
            "move the folder to that of its kind, such as `clothes/{base}`"
        )));
    }
    Some(finding.help(did_you_mean(
        near,
        "rename it to the kind of its assets, such as `clothes`, `hair` or `eyes`",
    )))
}

/// Whether a file lies in a folder at the top, as an asset in its own.
fn is_directly_in(file: &FileFacts) -> bool {
    file.rel.matches('/').count() == 1
}

/// What is listed, made once for all folders.
pub(super) struct Listed<'v> {
    /// The base meshes that assets are for.
    bases: BTreeSet<&'v str>,
    /// The names of assets, whatever base mesh they are for.
    names: BTreeSet<&'v str>,
    /// Folders that hold a skeleton which is looked for in `rigs`.
    renamed_rigs: BTreeSet<&'v str>,
}

impl<'v> Listed<'v> {
    pub(super) fn of(view: &'v View<'_>) -> Self {
        let bases = view.library.bases();
        let assets = bases.iter().flat_map(|base| view.library.of_base(base));
        let references = view.references.iter();
        let renamed = references.filter_map(|one| renamed_rigs(view.layers.checked, one));
        Self {
            names: assets.map(|asset| asset.name.as_str()).collect(),
            renamed_rigs: renamed.collect(),
            bases,
        }
    }
}

/// Whether a worn asset is listed nowhere under its name.
fn is_lost(view: &View<'_>, listed: &Listed<'_>, file: &FileFacts) -> bool {
    let clothes = file.clothes();
    let Some(name) = clothes.and_then(|clothes| clothes.scanned.name.as_ref()) else {
        return false;
    };
    let base = file.rel.split('/').nth(1);
    match base.and_then(|base| listed.bases.get(base)) {
        Some(base) => view.library.named(base, &name.text).next().is_none(),
        None => !listed.names.contains(&*name.text),
    }
}

/// Folders in which other programs look for what `MakeHuman` 2 has elsewhere, and where that is.
const OF_OTHERS: [(&str, &str, &str); 4] = [
    ("custom", "target", "a folder below `target/<base>`"),
    ("targets", "target", "a folder below `target/<base>`"),
    ("proxymeshes", "proxy", "a folder below `proxy/<base>`"),
    ("proxymeshes", "mhclo", "a folder below `clothes/<base>`"),
];

/// What lies where `MakeHuman` 1 or MPFB would look for it, in data that are not theirs as well.
pub(super) fn in_folders_of_others(rule: &Rule, view: &View<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers.checked;
    let is_shared = layer
        .layouts
        .iter()
        .any(|layout| layout.application != Application::Makehuman2);
    if is_shared || layer.is_loose || layer.pack.is_some() {
        return;
    }
    let at_top = layer
        .files
        .values()
        .filter(|file| !file.rel.contains('/') && extension(&file.rel) == "target");
    for file in at_top.filter(|file| !file.is_loose) {
        let message = format!("`{}` lies in no folder of targets", file.rel);
        let finding = rule.at(file, Place::File, message).key("top");
        out.push(finding.help(
            "move it to a folder below `target/<base>`, if it is made for one of its base meshes",
        ));
    }
    for (folder, suffix, right) in OF_OTHERS {
        let files = layer
            .below(folder)
            .filter(|file| extension(&file.rel) == suffix && !file.is_loose);
        let files: Vec<&FileFacts> = files.collect();
        let Some(first) = files.first() else { continue };
        let what = if suffix == "target" {
            "target"
        } else {
            "asset"
        };
        let message = format!(
            "{} in `{folder}`, where MakeHuman 2 does not look for any",
            counted(files.len(), what)
        );
        let finding = rule
            .at(first, Place::File, message)
            .key(format!("folder {folder} {suffix}"));
        let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
        let finding = finding.evidence(Evidence::of_cases(files.iter().map(|file| file.shown())));
        // With the lists of sliders it is the whole folder.
        let has_sliders = || {
            layer
                .below(folder)
                .any(|file| file.file_name() == "modelling.json")
        };
        let help = if folder == TARGETS_OF_OTHERS && !layer.has_folder("target") && has_sliders() {
            "rename the folder to `target`".to_owned()
        } else {
            format!("move them to {right}, if they are made for one of its base meshes")
        };
        out.push(finding.help(help));
    }
}
