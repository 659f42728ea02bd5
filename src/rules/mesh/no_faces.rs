//! A mesh has faces.

use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::obj::Mesh;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "shows nothing at all and takes the figure for 0 cm tall; the glTF export stops with a ValueError",
        )],
        docs: "A mesh without a line `f …` is a cloud of points.\n\nMakeHuman 2 loads it without a message. Nothing of it can \
            be seen, every height is 0, and the export to glTF stops with a ValueError because there is nothing to write. Faces in \
            groups that are not shown are another matter (`base-unknown-equipment`).\n\nExport the mesh again, with its faces.",
        ..RuleInfo::new("mesh-no-faces", Level::Error, "a mesh has vertices and no faces")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = file.mesh().filter(|mesh| is_cloud(mesh)) else { return };
    if is_in_archive(view, file, is_cloud) {
        return;
    }
    let vertices = mesh.facts.vertices;
    let finding = RULE
        .at(file, Place::File, format!("the mesh has {vertices} vertices and no face"))
        .help("export the mesh again, with its faces")
        .evidence(Evidence::counted(vertices).out_of(vertices));
    out.push(weigh(view, file, finding));
}

/// Faces that could not be read would be some, too.
fn is_cloud(mesh: &Mesh) -> bool {
    let facts = &mesh.facts;
    mesh.faces.is_empty() && facts.vertices > 0 && facts.unreadable_lines == 0 && facts.face_out_of_range.count == 0
}
