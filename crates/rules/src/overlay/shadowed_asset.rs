//! Which assets of the system the user's data replace, and what in them is never looked at.

use std::collections::BTreeSet;

use super::super::library::shelves::hidden;
use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::{Kind, extension};
use mhlint_repo::makehuman2::{Asset, View};
use mhlint_repo::{FileFacts, Layer, makehuman1, mpfb};
use mhlint_source::{depth, parent};

pub(crate) static RULE: Rule = Check::LibrariesOfAll(run, shared, of_mpfb).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "lists the user's asset in place of the system's",
        ),
        (
            Makehuman1,
            "takes the user's file wherever it is named, also in materials of the system",
        ),
        (Mpfb, "takes the user's file in place of its own"),
    ],
    docs: include_str!("shadowed_asset.md").trim_ascii_end(),
    of_library: true,
    ..RuleInfo::new(
        "overlay-shadowed-asset",
        Level::Info,
        "an asset of the user replaces one of the system",
    )
});

const UNUSED: Case = &[(
    Makehuman2,
    Level::Warning,
    "never uses it: it takes what lies beside the system's asset",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let is_user = view
        .layers
        .user
        .is_some_and(|user| std::ptr::eq(user, view.layers.checked));
    if view.layers.is_one_root() || !is_user {
        return;
    }
    for base in view.library.bases() {
        for clash in view.library.clashes(base) {
            out.extend(replacing(view, &clash));
        }
    }
    let Some(system) = view.layers.system else {
        return;
    };
    let (own, systems) = (asset_folders(view.layers.checked), asset_folders(system));
    let is_idle = |file: &&FileFacts| {
        let folder = parent(&file.rel);
        is_part(file)
            && systems.contains(folder)
            && !own.contains(folder)
            && view.references.to_file(file).next().is_none()
    };
    let idle = grouped(
        view.layers
            .checked
            .files
            .values()
            .filter(is_idle)
            .map(|file| (parent(&file.rel), file)),
    );
    out.extend(
        idle.into_iter()
            .filter_map(|(folder, files)| unused(view, folder, &files)),
    );
}

/// Folders of MakeHuman 1 whose files are named from anywhere.
const SHARED: [&str; 4] = ["litspheres", "textures", "shaders", "uvs"];

fn shared(view: &makehuman1::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (checked, Some(system)) = (view.layers.checked, view.layers.system) else {
        return;
    };
    if view.layers.checks_system() {
        return;
    }
    for file in SHARED.into_iter().flat_map(|folder| checked.below(folder)) {
        let Some(other) = system.file(&file.rel) else {
            continue;
        };
        let help = "give it a name of its own if it is not meant to replace that one";
        out.push(in_place_of(other, file).help(help));
    }
}

/// UV layers, and poses and settings of skins, which were copied once
/// (`docs/loaders/mpfb/folders.md#lookups`, `docs/loaders/mpfb/poses.md#stored-poses`,
/// `docs/loaders/mpfb/materials.md#settings-of-skins`,
/// `docs/loaders/mpfb/materials.md#finding-uv-layers`).
fn of_mpfb(view: &mpfb::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (checked, Some(system)) = (view.layers.checked, view.layers.system) else {
        return;
    };
    if view.layers.checks_system() {
        return;
    }
    hidden(&RULE, view, out);
    let settings = checked.file("config/enhanced_settings.default.json");
    let shipped = |file: &FileFacts| match file.rel.strip_prefix("config/") {
        Some(name) => system.file(&format!("settings/{name}")),
        None => system.file(&file.rel),
    };
    let poses = checked
        .below("poses")
        .filter(|file| file.kind == Kind::StoredPose);
    for file in checked.below("uv_layers").chain(poses).chain(settings) {
        // A copy changes nothing.
        let is_other =
            |other: &&FileFacts| file.size != other.size || file.content_hash != other.content_hash;
        let Some(other) = shipped(file).filter(is_other) else {
            continue;
        };
        out.push(in_place_of(other, file).help("remove it if the one of MPFB is to be used"));
    }
}

/// A file that is taken in place of one of the system.
fn in_place_of(other: &FileFacts, file: &FileFacts) -> Finding {
    let message = format!("replaces the system's `{}`", other.rel);
    let finding = RULE.at(file, Place::File, message).key(&file.rel);
    finding.related(other.path.clone(), Place::File, "the replaced file")
}

fn replacing(view: &View<'_>, clash: &[&Asset<'_>]) -> Option<Finding> {
    let own = clash
        .iter()
        .find(|asset| view.layers.is_checked(asset.file))?;
    let system = clash
        .iter()
        .find(|asset| !view.layers.is_checked(asset.file))?;
    // Of skeletons the program itself says which it takes.
    if own.category == "rigs" {
        return None;
    }
    let message = format!("replaces the system's `{}`", system.file.rel);
    let finding = RULE
        .at(own.file, Place::File, message)
        .key(format!("{} {}", own.name, own.uuid));
    let finding = finding.related(system.file.path.clone(), Place::File, "the replaced asset");
    Some(finding.help("give it a name and a uuid of its own if both are to be listed"))
}

/// Folders with something in them that is worn.
fn asset_folders(layer: &Layer) -> BTreeSet<&str> {
    // One whose suffix is in capitals has a finding of its own.
    let is_asset = |file: &&FileFacts| {
        matches!(
            &*extension(&file.rel).to_lowercase(),
            "mhclo" | "proxy" | "mhbin"
        )
    };
    let assets = layer.files.values().filter(is_asset);
    assets.map(|file| parent(&file.rel)).collect()
}

/// Whether a file would be part of an asset in its folder.
fn is_part(file: &FileFacts) -> bool {
    matches!(extension(&file.rel), "mhmat" | "obj") && depth(&file.rel) == 4
}

fn unused(view: &View<'_>, folder: &str, files: &[&FileFacts]) -> Option<Finding> {
    let first = files.first()?;
    let message = match files.len() {
        1 => format!(
            "`{}` has no asset beside it: the asset is in the system data",
            first.file_name()
        ),
        count => format!(
            "{} in `{folder}` have no asset beside them: the asset is in the system data",
            counted(count, "file")
        ),
    };
    let finding = RULE
        .at(first, Place::File, message)
        .case(UNUSED)
        .asset(view.layers.checked.display(folder));
    let parts = files.iter().map(|file| (file.file_name(), &file.path));
    let finding = finding.parts_in(parts).evidence(Evidence::of_cases(
        files.iter().map(|file| file.file_name()),
    ));
    Some(finding.help(
        "remove what is not used; a changed asset needs all of its files here, with a name and a \
            uuid of its own",
    ))
}
