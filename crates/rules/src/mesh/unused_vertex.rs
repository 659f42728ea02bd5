//! Vertices that no face uses.

use super::super::{Check, Rule, RuleCx};
use super::{ReadMesh, of_body, read};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Case, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::obj::{Mesh, MeshFacts};
use mhlint_repo::{FileFacts, ReferenceKind, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "keeps and counts such vertices but never shows them",
        ),
        (
            Makehuman1,
            "does not put the asset on: it loads no mesh with loose vertices",
        ),
        (
            Mpfb,
            "drops the vertex: where the rows of the asset count it, all later ones belong to \
            other vertices",
        ),
    ],
    levels: &[(Makehuman1, Level::Error), (Mpfb, Level::Warning)],
    docs: include_str!("unused_vertex.md").trim_ascii_end(),
    counts: "vertices",
    ..RuleInfo::new("mesh-unused-vertex", Level::Info, "no face uses a vertex")
});

const NOT_COUNTED: Case = &[(
    Mpfb,
    Level::Info,
    "drops the vertex: no row is for it, so nothing changes",
)];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if view.is_makehuman1() {
        let finding = read(view, file).and_then(|mesh| loose(view, file, &mesh));
        return out.extend(finding);
    }
    if view.is_mpfb() {
        let finding = read(view, file)
            .filter(|mesh| mesh.asset.is_some())
            .and_then(|mesh| loose(view, file, &mesh));
        let finding = finding.map(|one| {
            if counts_loose(view, file) {
                one
            } else {
                one.case(NOT_COUNTED)
            }
        });
        return out.extend(finding);
    }
    // Behind an archive it is told of that one.
    if view.is_replaced(&file.rel) {
        return;
    }
    // Faces that could not be read may be the ones that use them; a mesh without faces has a
    // finding of its own.
    let is_whole = |mesh: &&Mesh| can_be_read(&mesh.facts) && !mesh.faces.is_empty();
    let Some(mesh) = of_body(file).filter(is_whole) else {
        return;
    };
    let tally = &mesh.facts.unused;
    let Some((_, vertex)) = tally.first.first() else {
        return;
    };
    let vertex = view
        .landmarks(file)
        .map_or_else(|| format!("vertex {vertex}"), |body| body.vertex(*vertex));
    let message = match tally.count {
        1 => format!("no face uses {vertex}"),
        count => format!(
            "{count} of {} vertices are not used by any face, first {vertex}",
            mesh.facts.vertices
        ),
    };
    let help = "leave it: without the vertex all later ones have other numbers, and targets, \
        weights and clothes no longer fit";
    out.push(
        RULE.at(file, Place::File, message)
            .help(help)
            .evidence(tally.evidence(mesh.facts.vertices)),
    );
}

/// The mesh of an asset; MakeHuman 1 refuses it as a whole. Faces that could not be read may be the
/// ones that use the vertices.
fn loose(view: &View<'_>, file: &FileFacts, mesh: &ReadMesh<'_>) -> Option<Finding> {
    let tally = &mesh.facts.unused;
    let (_, vertex) = tally
        .first
        .first()
        .filter(|_| can_be_read(mesh.facts) && mesh.faces > 0)?;
    let first = mesh.named(view, file, *vertex);
    let message = match tally.count {
        1 => format!("no face uses {first}"),
        count => format!(
            "{count} of {} vertices are not used by any face, first {first}",
            mesh.facts.vertices
        ),
    };
    let help = match mesh.asset {
        Some(_) => {
            "delete loose vertices in the 3D program, then export mesh and asset again: without \
                the line all later vertices get other numbers"
        }
        None => "restore the mesh: its vertices are the same in all copies of MakeHuman 1",
    };
    let finding = RULE
        .at(file, Place::File, message)
        .help(help)
        .evidence(tally.evidence(mesh.facts.vertices));
    Some(mesh.weigh(view, file, finding, &[]))
}

/// Whether an asset has rows for more vertices of this mesh than its faces use.
fn counts_loose(view: &View<'_>, file: &FileFacts) -> bool {
    let Some(used) = file.asset_mesh().map(AssetMesh::used) else {
        return false;
    };
    view.references()
        .to_file(file)
        .filter(|one| one.kind == ReferenceKind::AssetMesh)
        .filter(|one| one.from.encoding.invalid_utf8_at.is_none())
        .filter_map(|one| one.from.clothes())
        .any(|clothes| clothes.flow.rows > used)
}

fn can_be_read(facts: &MeshFacts) -> bool {
    (facts.unreadable_lines, facts.face_out_of_range.count) == (0, 0)
        && facts.short_faces.is_empty()
}
