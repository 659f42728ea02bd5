//! Positions must be finite.

use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application::Makehuman2, Element, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "loses everything computed from the vertex: normals, joints, the height of the body")],
    docs: "The position of a vertex is `nan` or infinite.\n\n\
        Python reads `nan` and `inf` as numbers, so MakeHuman 2 loads the mesh. Everything computed from the \
        vertex is lost: the normals around it, joints and fitted assets that use it, and the height of the \
        body.\n\n\
        Give the vertex a finite position.",
    counts: "vertices",
    ..RuleInfo::new("mesh-non-finite", Level::Error, "the position of a vertex is not finite")
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = file.mesh() else { return };
    let tally = &mesh.facts.non_finite;
    let Some((line, vertex)) = tally.first.first() else { return };
    if is_in_archive(view, file, |mesh| mesh.facts.non_finite.count > 0) {
        return;
    }
    let named = view.landmarks(file).map_or_else(|| format!("vertex {vertex}"), |body| body.vertex(*vertex));
    let message = match tally.count {
        1 => format!("the position of {named} is not finite"),
        count => format!("the positions of {count} vertices are not finite, first {named}"),
    };
    let element = Element { kind: "vertex", index: vertex.unsigned_abs() };
    let place = if *line == 0 { Place::Element(element) } else { Place::Row(*line, element) };
    let finding = RULE
        .at(file, place, message)
        .help("give the vertex a finite position")
        .evidence(tally.evidence(mesh.facts.vertices));
    out.push(weigh(view, file, finding));
}
