//! Materials beside the folders of assets, which are offered for assets without materials of their
//! own (`docs/loaders/makehuman2/materials.md#alternative-materials`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, are, counted};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, grouped};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, ReferenceKind, View};
use mhlint_source::parent;

const UNOFFERED: Case = &[(
    Makehuman2,
    Level::Warning,
    "offers them for no asset: each has materials in its own folder, and only these count",
)];

/// The folder of shared materials, `eyes/<base>/materials`.
const SHARED: &str = "materials";

/// Those that are offered for nothing.
pub(super) fn unoffered(rule: &Rule, view: &View<'_>) -> Vec<Finding> {
    let layer = view.layers().checked;
    // The standard material of an asset is there without being offered.
    let standard = view
        .assets()
        .iter()
        .filter_map(|worn| worn.reference(ReferenceKind::AssetMaterial)?.meant());
    let named: BTreeSet<&str> = standard.map(|file| file.path.as_str()).collect();
    let shared = layer
        .files
        .values()
        .filter(|file| file.kind == Kind::Material && !named.contains(file.path.as_str()));
    let by_folder = grouped(shared.filter_map(|file| Some((sort_of(file)?, file))));
    let folders = folders_of_assets(view);
    let lost = by_folder.into_iter().filter(|(sort, _)| {
        let folders = folders.get(sort);
        folders.is_some_and(|folders| folders.iter().all(|folder| has_own(view, folder)))
    });
    lost.filter_map(|(sort, files)| finding(rule, sort, &files))
        .collect()
}

/// `eyes/<base>` for a file directly in `eyes/<base>/materials`.
fn sort_of(file: &FileFacts) -> Option<&str> {
    let sort = parent(&file.rel).strip_suffix(SHARED)?.strip_suffix('/')?;
    (sort.matches('/').count() == 1 && !sort.starts_with("skins/")).then_some(sort)
}

/// The folders in which the meshes of assets lie, by the one above.
fn folders_of_assets<'a>(view: &View<'a>) -> BTreeMap<&'a str, BTreeSet<&'a str>> {
    let meshes = view
        .assets()
        .iter()
        .filter_map(|worn| worn.reference(ReferenceKind::AssetMesh)?.found());
    let mut folders: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for folder in meshes.map(|mesh| parent(&mesh.rel)) {
        folders.entry(parent(folder)).or_default().insert(folder);
    }
    folders
}

/// Those of some files that are materials.
pub(super) fn materials_of<'l>(
    files: impl Iterator<Item = &'l FileFacts>,
) -> impl Iterator<Item = &'l FileFacts> {
    files.filter(|file| file.kind == Kind::Material)
}

/// Whether a folder of assets has materials of its own.
fn has_own(view: &View<'_>, folder: &str) -> bool {
    view.layers()
        .strongest_first()
        .any(|layer| materials_of(layer.below(folder)).next().is_some())
}

fn finding(rule: &Rule, sort: &str, files: &[&FileFacts]) -> Option<Finding> {
    let first = files.first()?;
    let (materials, are) = (counted(files.len(), "material"), are(files.len()));
    let message = format!("{materials} in `{sort}/{SHARED}` {are} not offered");
    let finding = rule
        .at(first, Place::File, message)
        .key(sort)
        .case(UNOFFERED);
    let finding = finding.parts_in(files.iter().map(|file| (file.shown(), &file.path)));
    let finding = finding.evidence(Evidence::of_cases(
        files.iter().map(|file| file.file_name()),
    ));
    Some(finding.help("move them to the folder of the asset that they are for"))
}
