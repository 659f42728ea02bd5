//! The mesh of an asset has texture coordinates.

use super::super::{Check, Rule, RuleCx};
use super::of_asset;
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Finding, Level, Place, RuleInfo,
};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "shows one colour of each texture all over the asset, here and in exports"), (Makehuman1, "shows one colour of each texture all over the asset")],
    docs: "No face of the mesh of an asset has texture coordinates: its faces are written `v` or `v//n` instead of `v/t`.\n\n\
        MakeHuman 2 loads the mesh and uses the same point of a texture for all of it. Base meshes are not reported: \
        without a skin they do without.\n\n\
        Unwrap the mesh, and export it with texture coordinates and in the same order of vertices.",
    ..RuleInfo::new("mesh-no-uv", Level::Warning, "the mesh of an asset has no texture coordinates")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = of_asset(view, file).filter(|mesh| mesh.faces > 0 && !mesh.has_uvs) else { return };
    if mesh.facts.unreadable_lines > 0 || mesh.facts.face_out_of_range.count > 0 {
        return;
    }
    let finding = RULE.at(file, Place::File, "no face has texture coordinates");
    out.push(finding.help("unwrap the mesh, and export it with texture coordinates in the same order of vertices"));
}
