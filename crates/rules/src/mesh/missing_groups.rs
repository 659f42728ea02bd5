//! The base mesh of MakeHuman 1 has groups for joints and helpers.

use super::super::{Check, Rule, RuleCx, either};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::{HIDDEN, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "draws joints and helpers together with the body, and does not find joints by their names",
    )],
    docs: include_str!("missing_groups.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-missing-groups",
        Level::Warning,
        "the base mesh has no groups of joints or helpers",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let sound = view
        .mesh
        .filter(|(file, mesh)| mesh.is_sound() && view.layers.is_checked(file));
    let Some((file, mesh)) = sound else { return };
    let has = |start: &str| {
        mesh.groups
            .iter()
            .any(|group| group.name.starts_with(start))
    };
    let missing: Vec<String> = HIDDEN
        .into_iter()
        .filter(|start| !has(start))
        .map(|start| format!("`{start}`"))
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = format!("no group of the base mesh begins with {}", either(&missing));
    let help = "restore the mesh, or export it with its groups (`g` lines) and in the same order \
        of vertices";
    out.push(RULE.at(file, Place::File, message).help(help));
}
