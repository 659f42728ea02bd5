//! Faces must use what exists.

use super::super::cause::mesh::weigh;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Case, Finding, Level, Place, RuleInfo, Tally};
use crate::discover::Kind;
use crate::formats::obj::Mesh;
use crate::repo::{FileFacts, View};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "stops with an IndexError while it loads the base")],
        docs: "Faces name vertices and texture coordinates by number, from 1. Numbers beyond the last one stop \
            MakeHuman 2; so do 0 and negative numbers, which the format otherwise allows for counting \
            backwards.\n\nUsually lines are missing in the file. Export the mesh again, with absolute numbers.",
        ..RuleInfo::new(
            "mesh-face-out-of-range",
            Level::Error,
            "a face uses a vertex or texture coordinate that does not exist",
        )
    },
    check: Check::File(run),
};

const BELOW_ONE: Case =
    &[(Application::Makehuman2, Level::Error, "stops with an OverflowError while it loads the base")];

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = file.mesh() else { return };
    let tally = &mesh.facts.face_out_of_range;
    let Some((line, number)) = tally.first.first() else { return };
    if file.kind == Kind::MeshArchive {
        return out.push(packed(file, mesh, tally, *number));
    }
    let (vertices, uvs) = (mesh.facts.vertices, mesh.uvs.len());
    let message =
        format!("a face uses number {number}, but there are {vertices} vertices and {uvs} texture coordinates");
    let lines = tally.first.iter().map(|(line, _)| format!("line {line}"));
    let finding = RULE
        .at(file, Place::Line(*line), message + &more(tally))
        .help("number vertices from 1; export the mesh again if lines are missing")
        .evidence(tally.evidence(mesh.faces.len()).showing(lines));
    let finding = if *number < 1 { finding.case(BELOW_ONE) } else { finding };
    out.push(weigh(view, file, finding));
}

/// Packed faces are numbered from 0, with the copies of vertices at seams behind the vertices.
fn packed(file: &FileFacts, mesh: &Mesh, tally: &Tally, number: i64) -> Finding {
    let positions = mesh.size().with_seams;
    let message = format!("a face uses position {number}, but there are {positions} positions{}", more(tally));
    RULE.at(file, Place::File, message)
        .help("pack the mesh anew with compile_meshes.py")
        .evidence(tally.evidence(mesh.faces.len() + tally.first.len()))
}

fn more(tally: &Tally) -> String {
    if tally.count > 1 { format!(" ({} faces like it)", tally.count) } else { String::new() }
}
