//! A mesh has faces.

use super::super::cause::is_unmet;
use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Case, Evidence, Finding, Level, Place, RuleInfo};
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
            groups that are not shown are another matter (`base-unknown-equipment`). A text without a line `v …` either, such as a web page that was \
            saved in place of the file, stops MakeHuman 2 at start.\n\nExport the mesh again, with its faces.",
        ..RuleInfo::new("mesh-no-faces", Level::Error, "a mesh has no faces")
    },
    check: Check::File(run),
};

const NO_MESH: Case =
    &[(Application::Makehuman2, Level::Error, "stops at start with an IndexError while it loads the base mesh")];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = file.mesh().filter(|mesh| is_cloud(mesh)) else { return };
    if is_in_archive(view, file, is_cloud) {
        return;
    }
    if mesh.facts.vertices == 0 {
        if is_other_text(view, file) {
            let message = format!("`{}` is no OBJ: it has neither vertices nor faces", file.file_name());
            let help = "restore the mesh: this is the text of another file, such as a web page";
            let finding = RULE.at(file, Place::File, message).case(NO_MESH).help(help);
            out.push(weigh(view, file, finding));
        }
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
    mesh.faces.is_empty() && facts.unreadable_lines == 0 && facts.face_out_of_range.count == 0
}

/// Whether there is a text of which the loader takes no line. An empty file, and one that is not UTF-8, have findings of
/// their own.
fn is_other_text(view: &View<'_>, file: &FileFacts) -> bool {
    let encoding = &file.encoding;
    let is_empty = file.size == 0 || encoding.blank || encoding.only_comments;
    !is_empty && encoding.invalid_utf8_at.is_none() && !is_unmet(view, file)
}
