//! The vertices of a base mesh keep their order.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Confidence, Evidence, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, ForeignMesh, ForeignSign, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "moves other vertices than targets, weights and joints were made for, without a message",
        )],
        docs: "Targets, weights and skeletons know a vertex by its number in `base.obj`. A program that writes objects or groups in \
            another order gives vertices other numbers, and everything that was made before moves the wrong ones. MakeHuman 2 loads it all.\n\nIt shows in the joint \
            cubes: more than half of the joints of the skeleton for poses have no vertex in the group `joint-…` of their name, or, where their names are others, in \
            any. Nothing else is checked against such a mesh.\n\nExport the mesh with the order kept (in Blender: `Keep Vertex Order`), or \
            take the old base.obj and move its vertices.",
        ..RuleInfo::new("mesh-vertex-order", Level::Warning, "a base mesh whose vertices are in another order")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(ForeignMesh { file, sign: ForeignSign::Order { strayed, of }, .. }) = base.foreign_mesh else { return };
    let Some((rig, _)) = base.pose_rig() else { return };
    let message = format!("the vertices are in another order: {strayed} of {of} joints have none in their cube");
    let mut evidence = Evidence::counted(strayed);
    evidence.of = Some(of as u64);
    let finding = RULE.at(file, Place::File, message).confidence(Confidence::Medium).evidence(evidence);
    let finding = finding.related(rig.file.path.clone(), Place::File, "the skeleton that is made for another order");
    let help = "export the mesh with its vertices in the old order; nothing else of this base is checked against it";
    let finding = finding.help(help).against(&rig.file.path);
    out.push(finding);
}
