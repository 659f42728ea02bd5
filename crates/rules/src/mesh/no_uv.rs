//! The mesh of an asset has texture coordinates.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use mhlint_discover::Kind;
use mhlint_repo::{FileFacts, Reference, ReferenceKind, View, Worn};
use mhlint_source::{folders_above, parent};

pub(crate) static RULE: Rule = Check::Repository(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "paints the whole asset with a single point of each texture, on screen and in exports",
        ),
        (
            Makehuman1,
            "paints the whole asset with a single point of each texture",
        ),
    ],
    docs: include_str!("no_uv.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-no-uv",
        Level::Warning,
        "the mesh of an asset has no texture coordinates",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let bare = view
        .assets()
        .iter()
        .filter_map(|worn| Some((worn, bare_mesh(worn)?)));
    let offered = textured_folders(view);
    let bare = bare
        .filter(|(worn, file)| view.layers().is_checked(file) && has_texture(&offered, worn, file));
    // Several assets may have one mesh.
    let files: BTreeMap<&str, &FileFacts> =
        bare.map(|(_, file)| (file.path.as_str(), file)).collect();
    for file in files.into_values() {
        let finding = RULE.at(file, Place::File, "no face has texture coordinates");
        out.push(
            finding.help(
                "unwrap the mesh and export it with texture coordinates; keep the vertex order",
            ),
        );
    }
}

/// The mesh of an asset, if it has faces and no texture coordinates.
fn bare_mesh<'a>(worn: &Worn<'a>) -> Option<&'a FileFacts> {
    let (file, mesh) = worn
        .mesh()
        .filter(|(_, mesh)| mesh.faces > 0 && !mesh.has_uvs)?;
    (mesh.facts.unreadable_lines == 0 && mesh.facts.face_out_of_range.count == 0).then_some(file)
}

fn is_textured(file: &FileFacts) -> bool {
    file.material()
        .is_some_and(|material| !material.textures.is_empty())
}

/// The folders below which a material with a texture lies.
fn textured_folders<'a>(view: &View<'a>) -> BTreeSet<&'a str> {
    let files = view.layers().checked.files.values();
    files
        .filter(|file| file.kind == Kind::Material && is_textured(file))
        .flat_map(|file| folders_above(parent(&file.rel)))
        .collect()
}

/// Whether a material that the asset names, or one that is offered for it, has a texture. A
/// topology wears the skins.
fn has_texture(offered: &BTreeSet<&str>, worn: &Worn<'_>, mesh: &FileFacts) -> bool {
    if worn.is_topology() {
        return true;
    }
    let folder = parent(&mesh.rel);
    // In the folder of the base mesh lie those of all assets.
    folder.matches('/').count() >= 2 && offered.contains(folder)
        || worn
            .reference(ReferenceKind::AssetMaterial)
            .and_then(Reference::meant)
            .is_some_and(is_textured)
}
