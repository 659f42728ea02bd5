//! The vertices of a base mesh keep their order.

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::cubes::Strays;
use mhlint_repo::makehuman2::{Base, ForeignMesh, ForeignSign, View};
use mhlint_repo::{FileFacts, makehuman1};

pub(crate) static RULE: Rule = Check::EachBase(run, of_makehuman1, |_, _, _| ()).rule(RuleInfo {
    breaks: &[(Makehuman2, MOVES), (Makehuman1, MOVES)],
    docs: include_str!("vertex_order.md").trim_ascii_end(),
    ..RuleInfo::new(
        "mesh-vertex-order",
        Level::Warning,
        "the vertices of a base mesh are in another order",
    )
});

/// What the skeleton does to a mesh that lacks its vertices.
const SHORT: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `IndexError` while loading the base mesh",
)];

const MOVES: &str =
    "silently moves the wrong vertices: targets, weights and joints were made for other numbers";

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(ForeignMesh {
        file,
        sign: ForeignSign::Order(strays),
        ..
    }) = base.foreign_mesh
    else {
        return;
    };
    let Some((rig, _)) = base.pose_rig() else {
        return;
    };
    out.push(finding(file, rig.file, strays));
}

fn of_makehuman1(view: &makehuman1::View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, sign)) = view.foreign_mesh else {
        return;
    };
    let Some(rig) = view.base_rig() else { return };
    if view.layers.is_checked(file) || view.layers.is_checked(rig.file) {
        out.push(match sign {
            makehuman1::ForeignSign::Short(last) => short(view, file, rig.file, last),
            makehuman1::ForeignSign::Order(strays) => finding(file, rig.file, strays),
        });
    }
}

/// Vertices are missing that the skeleton and its weights name.
fn short(view: &makehuman1::View<'_>, file: &FileFacts, rig: &FileFacts, last: i64) -> Finding {
    let vertices = view
        .mesh
        .map(|(_, mesh)| mesh.facts.vertices)
        .unwrap_or_default();
    let message = format!(
        "the mesh has {vertices} vertices, but the base skeleton and its weights name vertices up \
            to {last}"
    );
    let finding = RULE
        .at(file, Place::File, message)
        .key("vertices")
        .case(SHORT);
    let finding = finding.related(
        rig.path.clone(),
        Place::File,
        "the skeleton of the missing vertices",
    );
    let help = "restore the base mesh, or export it again with all its vertices in their order; \
        until then nothing else is checked against it";
    finding.help(help).against(&rig.path)
}

fn finding(
    file: &FileFacts,
    rig: &FileFacts,
    Strays {
        are_torn,
        strayed,
        of,
    }: Strays,
) -> Finding {
    let how = if are_torn {
        "cubes of joints are torn apart"
    } else {
        "joints are not at their cube"
    };
    let message = format!("the vertices have other numbers: {strayed} of {of} {how}");
    let mut evidence = Evidence::counted(strayed);
    evidence.of = Some(of as u64);
    let finding = RULE
        .at(file, Place::File, message)
        .confidence(Confidence::Medium)
        .evidence(evidence);
    let finding = finding.related(
        rig.path.clone(),
        Place::File,
        "the skeleton made for the old numbers",
    );
    let help = "restore the mesh from a copy with the old vertices in their order; until then \
        nothing else is checked against it";
    finding.help(help).against(&rig.path)
}
