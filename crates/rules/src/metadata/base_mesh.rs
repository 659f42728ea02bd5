//! The base mesh of MPFB is the one that its tables are for.

use super::super::{Check, Rule, RuleCx};
use super::{faces, size};
use mhlint_diag::{Application::Mpfb, Case, Finding, Level, Place, RuleInfo};
use mhlint_discover::Kind;
use mhlint_repo::mpfb::View;
use mhlint_repo::mpfb::misplaced::Misplaced;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "takes other vertices for joints, targets and groups: the whole figure is displaced",
    )],
    docs: include_str!("base_mesh.md").trim_ascii_end(),
    ..RuleInfo::new(
        "metadata-base-mesh",
        Level::Warning,
        "a base mesh that its tables are not for",
    )
});

const NO_UV: Case = &[(
    Mpfb,
    Level::Error,
    "fails with `IndexError` when an ink layer is put on",
)];

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if let Some((file, vertices, needed)) = view
        .foreign_mesh
        .filter(|(file, ..)| view.layers.is_checked(file))
    {
        let message = format!("the mesh has {vertices} vertices, and its tables are for {needed}");
        let finding = RULE.at(file, Place::File, message).key("vertices");
        out.push(finding.help("restore the base mesh"));
    }
    let mesh = view
        .mesh
        .filter(|(file, mesh)| view.layers.is_checked(file) && mesh.facts.vertices > 0);
    let layers = view.layers.strongest_first().chain(view.layers.beside);
    let has_ink = layers
        .flat_map(|layer| layer.below("ink_layers"))
        .any(|file| file.kind == Kind::InkLayer);
    if let Some((file, _)) = mesh.filter(|(_, mesh)| mesh.uvs.is_empty() && has_ink) {
        let finding = RULE
            .at(file, Place::File, "the mesh has no texture coordinates")
            .key("uv")
            .case(NO_UV);
        out.push(finding.help("export the mesh with texture coordinates"));
    }
    out.extend(
        mesh.zip(view.misplaced)
            .map(|((file, _), misplaced)| size::fault(&RULE, file, misplaced)),
    );
    // Vertices with other numbers make other faces.
    let is_told = view.misplaced.is_some_and(Misplaced::is_of_numbers);
    out.extend(
        mesh.filter(|_| !is_told)
            .and_then(|(file, mesh)| faces::of_mesh(&RULE, view, file, mesh)),
    );
}
