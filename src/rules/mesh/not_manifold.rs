//! An edge has two faces at most.

use super::super::{Check, Rule, RuleCx, counted};
use crate::diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use crate::eval::measures::Measures;
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "shows the faces as they are; smooth shading mixes sides that have nothing to do with one another"),
        (Makehuman1, "shows the faces as they are; smooth shading mixes sides that have nothing to do with one another"),
    ],
    docs: "More than two faces of an asset share an edge.\n\n\
        Both applications load and export it. A surface has two sides at each edge; where three faces or more meet, no \
        program can tell inside from outside: subdivision, cloth simulation and 3D printing of the exported figure go wrong \
        there, and the normals at the edge are a mean of unrelated faces. Often a surface was doubled and joined.\n\n\
        In Blender: Select > All by Trait > Non Manifold shows the edges.",
    counts: "edges",
    ..RuleInfo::new("mesh-not-manifold", Level::Info, "an edge with more than two faces")
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut told = std::collections::BTreeSet::new();
    for worn in body.worn {
        let edges = measures.worn.get(&worn.file.path).map(|measure| measure.shape.crowded_edges.as_slice());
        let Some(([one, other], (file, mesh))) = edges.and_then(|edges| edges.first().copied().zip(worn.mesh())) else {
            continue;
        };
        // Faces that stand twice, and those that no application takes, have findings of their own.
        let is_told = mesh.repeated > 0 || mesh.facts.ngons.count > 0;
        if is_told || !body.layers.is_checked(file) || !told.insert(&file.path) {
            continue;
        }
        let edges = edges.unwrap_or_default();
        let have = if edges.len() == 1 { "has" } else { "have" };
        let message = format!(
            "{} {have} more than two faces, first that from {} to vertex {other}",
            counted(edges.len(), "edge"),
            mesh.named(one)
        );
        let named = edges.iter().map(|[one, other]| format!("{one}-{other}"));
        let finding = RULE.at(file, Place::File, message).evidence(Evidence::of_unnamed(named));
        out.push(finding.help("remove faces that lie inside, or double their edges"));
    }
}
