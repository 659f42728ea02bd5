//! Positions must be finite.

use super::super::cause::mesh::{is_in_archive, weigh};
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Element, Finding, Level, Place, RuleInfo};
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "computes with it: whatever depends on the vertex (normals, joints, size of the body) is no number \
            either",
        )],
        docs: "Python reads `nan` and `inf` as numbers, and so MakeHuman 2 loads the mesh. Everything that is \
            computed from the vertex is lost: the normals around it, a joint or a fitted asset that uses it, the \
            height of the body.\n\nGive the vertex a position.",
        ..RuleInfo::new("mesh-non-finite", Level::Error, "the position of a vertex is not a number or infinite")
    },
    check: Check::File(run),
};

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = file.mesh() else { return };
    let tally = &mesh.facts.non_finite;
    let Some((line, vertex)) = tally.first.first() else { return };
    if is_in_archive(view, file, |mesh| mesh.facts.non_finite.count > 0) {
        return;
    }
    let message = match tally.count {
        1 => format!("the position of vertex {vertex} is not finite"),
        count => format!("the positions of {count} vertices are not finite, the first is vertex {vertex}"),
    };
    let element = Element { kind: "vertex", index: vertex.unsigned_abs() };
    let place = if *line == 0 { Place::Element(element) } else { Place::Row(*line, element) };
    let finding =
        RULE.at(file, place, message).help("give the vertex a position").evidence(tally.evidence(mesh.facts.vertices));
    out.push(weigh(view, file, finding));
}
