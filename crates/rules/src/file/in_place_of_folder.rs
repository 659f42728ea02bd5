//! Files in the place of folders, and folders in the place of files.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use super::super::cause::consequence::{Damage, consequence};
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Finding, Level, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_formats::Format;
use mhlint_repo::View;
use mhlint_source::file_name;

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "cannot open it, and may crash at start"),
        (Makehuman1, "cannot store anything in it"),
        (
            Mpfb,
            "finds nothing in it, or fails with an exception when it lists the folder",
        ),
    ],
    docs: include_str!("in_place_of_folder.md").trim_ascii_end(),
    ..RuleInfo::new(
        "file-in-place-of-folder",
        Level::Error,
        "a file instead of a folder, or a folder instead of a file",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layer = view.layers().checked;
    let finding = |rel: &str, stands: &str, belongs: &str, help: &str| {
        let name = file_name(rel);
        let message = format!("`{name}` is a {stands}, expected a {belongs}");
        let finding = RULE.in_layer(layer, rel, message).help(help);
        consequence(view, rel, Damage::Closed).map(|loss| loss.of(view, finding))
    };
    let bases = LazyCell::new(|| -> BTreeSet<&str> {
        let layers = view.layers().strongest_first();
        let files = layers.flat_map(|layer| layer.files.values());
        files
            .filter_map(|file| file.base_in(view.application()))
            .collect()
    });
    let is_base = |name: &str| bases.contains(name);
    for file in view
        .files()
        .filter(|file| file.unreadable.is_none() && !file.failed)
    {
        if (view.layout().is_folder)(&file.rel, &is_base) {
            out.extend(finding(
                &file.rel,
                "file",
                "folder",
                "remove or rename the file",
            ));
        }
    }
    // What looks like a target and is a folder, MPFB passes over.
    let is_listed =
        |kind: Kind| view.is_mpfb() && matches!(kind, Kind::Target | Kind::PackedTarget);
    // The lists of MakeHuman 1 pass over folders, whatever they are called.
    let is_opened = |folder: &str| {
        let kind = view.kind_at(folder);
        !view.is_makehuman1() && (is_file(kind) && !is_listed(kind) || is_archive(view, folder))
    };
    for folder in layer.folders.iter().filter(|folder| is_opened(folder)) {
        out.extend(finding(
            folder,
            "folder",
            "file",
            "rename the folder, or replace it with the file",
        ));
    }
}

/// Whether loaders open what is of this kind as a file.
fn is_file(kind: Kind) -> bool {
    Format::of(kind).is_text() || kind == Kind::TargetArchive
}

/// Whether a folder has the name of the archive that MakeHuman 2 makes of the asset beside it.
fn is_archive(view: &View<'_>, folder: &str) -> bool {
    (view.layout().scans)(folder) && view.layers().checked.text_of_archive(folder).is_some()
}
