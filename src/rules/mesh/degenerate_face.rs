//! A face has each of its vertices once.

use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::obj::{Mesh, Repeating};
use crate::repo::Body;

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "makes a triangle without area of it: where another corner was meant the surface has a hole",
        )],
        docs: "A face names a vertex twice.\n\nMakeHuman 2 cuts each face into triangles from its first corner, and says nothing \
            where one of them has no area: nothing of it is seen, and it is exported like the others. A face of four corners \
            of which two are one vertex is a triangle; the part of the surface up to the corner that was meant is missing. In a group \
            that is not shown this is an info.\n\nName the corner that was meant, or write the face as a triangle.",
        ..RuleInfo::new("mesh-degenerate-face", Level::Warning, "a face has a vertex twice")
    },
    check: Check::Body(run),
};

const HIDDEN: Case = &[(Application::Makehuman2, Level::Info, "never shows the face: its group is not a visible one")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = body.mesh else { return };
    let is_visible = |face: &&Repeating| is_visible(body, mesh, face);
    let (visible, hidden): (Vec<&Repeating>, Vec<&Repeating>) = mesh.facts.repeating.iter().partition(is_visible);
    let (told, is_hidden) = if visible.is_empty() { (hidden, true) } else { (visible, false) };
    let Some(first) = told.first() else { return };
    let message = match told.len() {
        1 => format!("the face has vertex {} twice", first.vertex),
        count => {
            format!("{count} of {} faces have a vertex twice, the first vertex {}", mesh.faces.len(), first.vertex)
        }
    };
    // Packed faces have no lines.
    let (place, told_by): (_, fn(&&Repeating) -> String) = match first.line {
        0 => (Place::File, |face| format!("vertex {}", face.vertex)),
        line => (Place::Line(line), |face| format!("line {}", face.line)),
    };
    let finding = RULE
        .at(file, place, message)
        .help("name the corner that was meant, or write a triangle")
        .parts(told.iter().map(|face| face.vertex))
        .evidence(Evidence::of_unnamed(told.iter().map(told_by)).out_of(mesh.faces.len()));
    out.push(if is_hidden { finding.case(HIDDEN) } else { finding });
}

fn is_visible(body: &Body<'_>, mesh: &Mesh, face: &Repeating) -> bool {
    let group = mesh.groups.get(face.group as usize);
    group.is_some_and(|group| body.shows(&group.name))
}
