//! Meshes of assets that are worn at once have different names.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, shown};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_discover::{archive_library_of, library_of};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_repo::{Body, FileFacts, Worn};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "does not pose one of the two when both are worn",
    )],
    docs: include_str!("name_clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-name-clash",
        Level::Warning,
        "two meshes with one name",
    )
});

const TEXT: &str = "give the object another name in the line `o` of one of the two files";
const PACKED: &str = "pack one of the two again from an OBJ with another name";

/// The library of which several assets can be worn at once.
const SEVERAL: &str = "clothes";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut known: BTreeMap<&str, Vec<(&Worn<'_>, &FileFacts)>> = BTreeMap::new();
    let sound = body.worn.iter().filter(|worn| !worn.is_topology());
    let sound =
        sound.filter_map(|worn| Some((worn, worn.mesh().filter(|(_, mesh)| body.opens(mesh))?)));
    for (worn, (file, mesh)) in sound {
        known
            .entry(name(file, mesh))
            .or_default()
            .push((worn, file));
    }
    for (name, meshes) in known {
        let checked = meshes
            .iter()
            .filter(|(worn, _)| body.layers.is_checked(worn.file));
        let told = checked.max_by_key(|(_, file)| &file.rel);
        let Some((worn, file)) = told.copied() else {
            continue;
        };
        let other = meshes.iter().find(|(other, mesh)| {
            worn.file.rel != other.file.rel && together(worn, other, file, mesh)
        });
        let Some((_, other)) = other else { continue };
        let shown = shown(name);
        let own = worn.mesh().and_then(|(_, mesh)| mesh.facts.object.as_ref());
        let place = own.map_or(Place::File, |(_, line)| Place::Line(*line));
        let message = format!(
            "the mesh `{shown}` has the name of that in {}",
            body.layers.named(other)
        );
        let finding = RULE.at(file, place, message).key(shown).related(
            other.path.clone(),
            Place::File,
            "the other",
        );
        let finding = finding.between([file.path.as_str(), other.path.as_str()]);
        let is_packed = file.asset_mesh().is_none();
        out.push(finding.help(if is_packed { PACKED } else { TEXT }));
    }
}

/// What a mesh is known by.
fn name<'v>(file: &'v FileFacts, mesh: &'v AssetMesh) -> &'v str {
    mesh.facts
        .object
        .as_ref()
        .map_or_else(|| file.stem(), |(name, _)| name)
}

/// Whether two assets can be worn at once. Those with one uuid cannot.
fn together(one: &Worn<'_>, other: &Worn<'_>, mesh: &FileFacts, other_mesh: &FileFacts) -> bool {
    let shelf = |rel: &str| {
        library_of(rel)
            .or_else(|| archive_library_of(rel))
            .map(str::to_owned)
    };
    let library = |worn: &Worn<'_>| shelf(&worn.file.rel);
    let written = |worn: &Worn<'_>| {
        worn.clothes()
            .and_then(|clothes| Some(clothes.last("uuid")?.value.clone()))
    };
    let packed = |worn: &Worn<'_>| {
        worn.packed_proxy()
            .and_then(|proxy| proxy.identity.last().cloned())
    };
    let uuid = |worn: &Worn<'_>| written(worn).or_else(|| packed(worn));
    let is_one = uuid(one).is_some() && uuid(one) == uuid(other);
    let is_free = library(one) != library(other) || library(one).as_deref() == Some(SEVERAL);
    is_free && !is_one && !std::ptr::eq(mesh, other_mesh)
}
