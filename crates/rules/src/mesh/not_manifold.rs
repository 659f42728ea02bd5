//! An edge has two faces at most.

use super::super::cause::worn::meshes;
use super::super::{Check, Rule, RuleCx, counted};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_repo::{Body, Worn};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "shows the faces as they are; smooth shading mixes sides that have nothing to do with \
                one another",
        ),
        (
            Makehuman1,
            "shows the faces as they are; smooth shading mixes sides that have nothing to do with \
                one another",
        ),
    ],
    docs: include_str!("not_manifold.md").trim_ascii_end(),
    counts: "edges",
    ..RuleInfo::new(
        "mesh-not-manifold",
        Level::Info,
        "an edge with more than two faces",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let crowded = |worn: &Worn<'_>| {
        measures
            .worn
            .get(&worn.file.path)
            .map_or(&[][..], |one| &one.shape.crowded_edges)
    };
    // Faces that stand twice, and those that no application takes, have findings of their own.
    let is_told = |mesh: &AssetMesh| mesh.repeated > 0 || mesh.facts.ngons.count > 0;
    for (worn, file, mesh) in meshes(body, |worn, mesh| {
        !crowded(worn).is_empty() && !is_told(mesh)
    }) {
        let edges = crowded(worn);
        let Some([one, other]) = edges.first() else {
            continue;
        };
        let have = if edges.len() == 1 { "has" } else { "have" };
        // Where that is on the figure, the row of the vertex tells.
        let row = usize::try_from(*one)
            .ok()
            .and_then(|one| worn.file.clothes()?.kept.get(one));
        let tied = row
            .map(|row| format!(", tied to {} of the body", body.vertex(row.vertices[0])))
            .unwrap_or_default();
        let message = format!(
            "{} {have} more than two faces, first that from {} to {}{tied}",
            counted(edges.len(), "edge"),
            mesh.named(*one),
            mesh.named(*other)
        );
        let named = edges.iter().map(|[one, other]| format!("{one}-{other}"));
        let finding = RULE
            .at(file, Place::File, message)
            .evidence(Evidence::of_unnamed(named));
        out.push(finding.help("remove faces that lie inside, or double their edges"));
    }
}
