//! The base mesh of MPFB is the one that its tables are for.

use super::super::{Check, Rule, RuleCx};
use super::{faces, size};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::mpfb::View;
use mhlint_repo::mpfb::misplaced::Misplaced;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, "takes other vertices for joints, targets and groups: the whole figure is displaced")],
    docs: "`base.obj` of MPFB and the tables in `mesh_metadata/` belong together. If the mesh has fewer vertices than \
        the mirror table and the vertex groups name, vertices were removed: all numbers behind them are those of other \
        vertices. Joints, targets, weights and clothes are displaced, without a message. Other rules leave the vertices \
        of such a mesh out. Loose vertices behind all others do no harm.\n\n\
        Without texture coordinates (`vt`) MPFB fails with `IndexError` when an ink layer is put on (an error, where there are ink layers).\n\n\
        If the tables of faces agree with one another, but not with the mesh, the mesh was exported with other numbers of \
        vertices or in another order of faces. A mesh of the size of the body that is not about 17 units (1.7 m) high, or \
        does not stand upright along y, makes a giant, a dwarf, or a body that lies, while the movements of sliders stay as \
        they are. If left and right are exchanged, or vertices have other numbers than in `hm08.mirror` or `basemesh_vertex_groups.json`, sliders, bones and \
        assets take hold of other places. What is measured on the mesh is then left out.\n\n\
        Restore the base mesh.",
    ..RuleInfo::new("metadata-base-mesh", Level::Warning, "a base mesh that its tables are not for")
});

const NO_UV: Case = &[(Mpfb, Level::Error, "fails with `IndexError` when an ink layer is put on")];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some((file, vertices, needed)) = view.foreign_mesh.filter(|(file, ..)| view.layers.is_checked(file)) {
        let message = format!("the mesh has {vertices} vertices, and its tables are for {needed}");
        let finding = RULE.at(file, Place::File, message).key("vertices");
        out.push(finding.help("restore the base mesh"));
    }
    let mesh = view.mesh.filter(|(file, mesh)| view.layers.is_checked(file) && mesh.facts.vertices > 0);
    let layers = view.layers.strongest_first().chain(view.layers.beside);
    let has_ink = layers.flat_map(|layer| layer.below("ink_layers")).any(|file| file.kind == Kind::InkLayer);
    if let Some((file, _)) = mesh.filter(|(_, mesh)| mesh.uvs.is_empty() && has_ink) {
        let finding = RULE.at(file, Place::File, "the mesh has no texture coordinates").key("uv").case(NO_UV);
        out.push(finding.help("export the mesh with texture coordinates"));
    }
    out.extend(mesh.zip(view.misplaced).map(|((file, _), misplaced)| size::fault(&RULE, file, misplaced)));
    // Vertices with other numbers make other faces.
    let is_told = view.misplaced.is_some_and(Misplaced::is_of_numbers);
    out.extend(mesh.filter(|_| !is_told).and_then(|(file, mesh)| faces::of_mesh(&RULE, view, file, mesh)));
}
