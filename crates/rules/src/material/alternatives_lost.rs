//! Materials that are offered for an asset must be found, also by saved models.

use std::collections::BTreeSet;

use super::super::cause::unfiled::is_of_no_base;
use super::super::{Check, Rule, RuleCx};
use super::alternatives_around::Around;
use super::alternatives_shared::{materials_of, unoffered};
use mhlint_diag::{
    Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo, grouped,
};
use mhlint_discover::extension;
use mhlint_repo::{Layer, Reference, ReferenceKind, View, Wearer, Worn};
use mhlint_source::{is_below, parent};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "does not offer the materials")],
    docs: include_str!("alternatives_lost.md").trim_ascii_end(),
    ..RuleInfo::new(
        "material-alternatives-lost",
        Level::Warning,
        "materials that are not offered, or lost in models",
    )
});

const OF_ASSET: Case = &[(
    Makehuman2,
    Level::Warning,
    "offers it, but a saved model goes back to the default material when it is loaded",
)];
const OF_SKIN: Case = &[(
    Makehuman2,
    Level::Warning,
    "offers it, but a saved model goes back to the default skin when it is loaded",
)];
const OF_ALL: Case = &[(
    Makehuman2,
    Level::Warning,
    "offers the materials of all assets in the folder, and loses the chosen one when the model is \
        loaded",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let layers = view.layers();
    // Where an asset names it, that is told.
    let texts = view.assets().iter().filter_map(Worn::clothes);
    let named: BTreeSet<&str> = texts
        .filter_map(|text| Some(&*text.last("material")?.value))
        .collect();
    for surface in view
        .surfaces()
        .iter()
        .filter(|surface| layers.is_checked(surface.file))
    {
        let name = surface.file.file_name();
        // That of the base mesh is never offered.
        let is_offered = surface.wearer != Wearer::Asset
            && !surface.file.rel.starts_with("base/")
            && !named.contains(name);
        if name.contains(char::is_whitespace) && is_offered {
            let finding = RULE
                .at(
                    surface.file,
                    Place::File,
                    format!("`{name}` has a space in its name"),
                )
                .key("space");
            let finding = finding.case(if surface.wearer == Wearer::Skin {
                OF_SKIN
            } else {
                OF_ASSET
            });
            out.push(finding.help(
                "rename the file without spaces, and write the new name in every `.mhclo` and \
                    `.mhm` that names it",
            ));
        }
    }
    capitals(view, out);
    out.extend(unoffered(&RULE, view));
    let bases: BTreeSet<&str> = view.body_names().into_iter().collect();
    let is_listed = |worn: &&Worn<'_>| !is_of_no_base(layers, &bases, worn.file);
    let own = view
        .assets()
        .iter()
        .filter(|worn| layers.is_checked(worn.file) && !worn.is_topology());
    let own = own.filter(is_listed);
    let meshes = own.filter_map(|worn| Some((worn, mesh(worn)?)));
    let by_folder = grouped(meshes.map(|(worn, mesh)| (parent(&mesh.rel), (worn, mesh))));
    let mut around = Around::of(layers.checked);
    for (folder, assets) in by_folder {
        if folder.matches('/').count() < 2 {
            out.extend(at_top(layers.checked, folder, &assets));
        } else {
            out.extend(
                assets
                    .iter()
                    .filter_map(|(worn, mesh)| elsewhere(&mut around, worn, mesh)),
            );
        }
    }
}

/// Materials whose extension is in capitals. That of an asset which names it is missing, and a skin
/// is not listed: these have findings of their own.
fn capitals(view: &View<'_>, out: &mut Vec<Finding>) {
    let named = view
        .assets()
        .iter()
        .flat_map(|worn| worn.references.iter().flatten());
    let named: BTreeSet<&str> = named
        .filter_map(Reference::meant)
        .map(|file| file.rel.as_str())
        .collect();
    let is_written =
        |rel: &str| extension(rel) != "mhmat" && extension(rel).eq_ignore_ascii_case("mhmat");
    for file in view
        .layers()
        .checked
        .files
        .values()
        .filter(|file| is_written(&file.rel))
    {
        if view.offers_material_at(&file.rel) && !named.contains(file.rel.as_str()) {
            let message = format!("`{}` has its extension in capitals", file.file_name());
            let finding = RULE.at(file, Place::File, message).key("capitals");
            out.push(finding.help(format!("rename it to `{}.mhmat`", file.stem())));
        }
    }
}

/// The mesh of an asset, which is there.
fn mesh<'w, 'a>(worn: &'w Worn<'a>) -> Option<&'w Reference<'a>> {
    let mesh = worn.reference(ReferenceKind::AssetMesh)?;
    mesh.found().map(|_| mesh)
}

/// The material that it names.
fn own_material<'a>(worn: &Worn<'a>) -> Option<&'a str> {
    let material = worn.reference(ReferenceKind::AssetMaterial)?;
    material.found().map(|file| file.rel.as_str())
}

/// Assets whose meshes lie in the folder of all assets, if there are materials besides their own.
fn at_top(layer: &Layer, folder: &str, assets: &[(&Worn<'_>, &Reference<'_>)]) -> Option<Finding> {
    let (first, mesh) = assets.first()?;
    let own = own_material(first);
    materials_of(layer.below(folder)).find(|file| Some(file.rel.as_str()) != own)?;
    let message = match assets.len() {
        1 => format!(
            "`{}` is in the folder of all assets, not in one of its own",
            mesh.text
        ),
        count => format!("the meshes of {count} assets are in the folder of all assets"),
    };
    let finding = RULE
        .at(first.file, mesh.place.clone(), message)
        .key("folder")
        .case(OF_ALL);
    let parts = assets
        .iter()
        .map(|(worn, mesh)| (worn.file.file_name(), &worn.file.path, mesh.place.clone()));
    let names = assets.iter().map(|(worn, _)| worn.file.file_name());
    let finding = finding.parts_at(parts).evidence(Evidence::of_cases(names));
    Some(finding.help("give each asset a folder of its own, with its mesh and its materials"))
}

/// An asset with materials around it, but not around its mesh.
fn elsewhere(around: &mut Around<'_>, worn: &Worn<'_>, mesh: &Reference<'_>) -> Option<Finding> {
    let (own, searched) = (parent(&worn.file.rel), parent(&mesh.rel));
    // Those of other assets are none of its own.
    if is_below(own, searched) || own.matches('/').count() < 2 {
        return None;
    }
    let (count, evidence) = around.lost(own, searched, own_material(worn))?;
    let message = match count {
        1 => format!("a material is not offered: the mesh is in `{searched}`"),
        count => format!("{count} materials are not offered: the mesh is in `{searched}`"),
    };
    let finding = RULE
        .at(worn.file, mesh.place.clone(), message)
        .key("folder");
    Some(
        finding
            .evidence(evidence)
            .help("keep asset, mesh and materials together in a folder of their own"),
    )
}
