//! `numverts` must be the vertex count of the base mesh.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Finding, Level, Place, RuleInfo};
use crate::repo::makehuman2::{Base, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "builds binary assets whose delete masks have the wrong length: wearing them with others ends in a ValueError",
        )],
        docs: "`numverts` is the number of `v` lines of `base.obj`.\n\nMakeHuman 2 itself never reads it, but its command line tools do. \
            `compile_meshes.py` makes the mask of hidden vertices of every binary asset that long; `adapt_morphs.py` counts by it. \
            A mask that is too long cannot be combined with those of other assets, and the program stops with a ValueError as soon as two \
            such assets are worn together. Nothing warns when the binaries are built.\n\nWrite the number of vertices of the mesh, \
            and build binary assets anew.",
        ..RuleInfo::new("base-vertex-count", Level::Error, "`numverts` differs from the base mesh")
    },
    check: Check::Makehuman2(run),
};

fn run(_: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let (Some((file, settings)), Some((mesh_file, mesh))) = (base.settings(), base.mesh) else { return };
    let Some(claimed) = settings.numverts.filter(|_| mesh.facts.unreadable_lines == 0) else { return };
    let vertices = mesh.facts.vertices;
    if i64::try_from(vertices).is_ok_and(|vertices| vertices == claimed) {
        return;
    }
    let message = format!("`numverts` is {claimed}, but the base mesh has {vertices} vertices");
    out.push(
        RULE.at(file, Place::pointer(["numverts"]), message)
            .key("numverts")
            .help(format!("write {vertices}, and compile binary assets of this base anew"))
            .related(mesh_file.path.clone(), Place::File, format!("has {vertices} vertices")),
    );
}
