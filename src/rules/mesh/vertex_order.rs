//! The vertices of a base mesh keep their order.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Confidence, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, ForeignMesh, ForeignSign, View};

pub(in crate::rules) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "silently moves the wrong vertices: targets, weights and joints were made for another order",
    )],
    docs: "The vertices of the base mesh are in another order than the skeleton expects. Targets, weights and \
        skeletons identify a vertex by its number in `base.obj`, and a program that exports objects or groups in \
        another order renumbers them.\n\n\
        MakeHuman 2 loads the mesh without a message and then moves the wrong vertices.\n\n\
        The joint cubes show it: more than half of the joints of the pose skeleton have no vertex in the group \
        `joint-…` with their name, or in any such group if none has their names. Nothing else is checked against \
        such a mesh.\n\n\
        Export the mesh with its vertex order kept (in Blender: `Keep Vertex Order`), or take the old base.obj and \
        move its vertices.",
    ..RuleInfo::new("mesh-vertex-order", Level::Warning, "the vertices of a base mesh are in another order")
});

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(ForeignMesh { file, sign: ForeignSign::Order { strayed, of }, .. }) = base.foreign_mesh else { return };
    let Some((rig, _)) = base.pose_rig() else { return };
    let message =
        format!("the vertices are in a different order: {strayed} of {of} joints have no vertex in their cube");
    let mut evidence = Evidence::counted(strayed);
    evidence.of = Some(of as u64);
    let finding = RULE.at(file, Place::File, message).confidence(Confidence::Medium).evidence(evidence);
    let finding = finding.related(rig.file.path.clone(), Place::File, "the skeleton made for the other order");
    let help = "restore the mesh from a copy with the old vertex order; until then nothing else is checked against it";
    let finding = finding.help(help).against(&rig.file.path);
    out.push(finding);
}
