//! Vertices that no face uses.

use super::super::{Check, Rule, RuleCx};
use super::of_asset;
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use crate::formats::asset_mesh::AssetMesh;
use crate::formats::obj::Mesh;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "keeps and counts such vertices but never shows them"),
        (Makehuman1, "does not put the asset on: it loads no mesh with loose vertices"),
    ],
    levels: &[(Makehuman1, Level::Error)],
    docs: "A vertex belongs to no face.\n\n\
        MakeHuman 2 keeps such vertices; they can be moved, weighted and used by joints and clothes like any \
        others. Programs that drop them on import number all later vertices differently, so that targets, weights \
        and clothes no longer fit.\n\nMakeHuman 1 loads no mesh of an asset with such a vertex (an error).\n\n\
        Keep them if something refers to them. Do not add new ones: removing one later renumbers the mesh.",
    counts: "vertices",
    ..RuleInfo::new("mesh-unused-vertex", Level::Info, "no face uses a vertex")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_makehuman1() {
        return out.extend(of_asset(view, file).and_then(|mesh| loose(file, mesh)));
    }
    // Behind an archive it is told of that one.
    if view.is_replaced(&file.rel) {
        return;
    }
    // Faces that could not be read may be the ones that use them; a mesh without faces has a finding of its own.
    let facts = |mesh: &Mesh| (mesh.facts.unreadable_lines, mesh.facts.face_out_of_range.count);
    let can_be_read = |mesh: &Mesh| facts(mesh) == (0, 0) && mesh.facts.short_faces.is_empty();
    let is_whole = |mesh: &&Mesh| can_be_read(mesh) && !mesh.faces.is_empty();
    let Some(mesh) = file.mesh().filter(is_whole) else { return };
    let tally = &mesh.facts.unused;
    let Some((_, vertex)) = tally.first.first() else { return };
    let vertex = view.landmarks(file).map_or_else(|| format!("vertex {vertex}"), |body| body.vertex(*vertex));
    let message = match tally.count {
        1 => format!("no face uses {vertex}"),
        count => format!("{count} of {} vertices are not used by any face, first {vertex}", mesh.facts.vertices),
    };
    let help = "leave it: without the vertex all later ones have other numbers, and targets, weights and clothes no longer fit";
    out.push(RULE.at(file, Place::File, message).help(help).evidence(tally.evidence(mesh.facts.vertices)));
}

/// MakeHuman 1 refuses the whole mesh.
fn loose(file: &FileFacts, mesh: &AssetMesh) -> Option<Finding> {
    let tally = &mesh.facts.unused;
    let (_, vertex) = tally.first.first().filter(|_| mesh.is_sound() && mesh.faces > 0)?;
    let first = mesh.named(*vertex);
    let message = match tally.count {
        1 => format!("no face uses {first}"),
        count => format!("{count} of {} vertices are not used by any face, first {first}", mesh.facts.vertices),
    };
    let help = "delete loose vertices in the 3D program, then export mesh and asset again: without the line all later vertices get other numbers";
    Some(RULE.at(file, Place::File, message).help(help).evidence(tally.evidence(mesh.facts.vertices)))
}
