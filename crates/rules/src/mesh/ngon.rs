//! Faces have three or four corners.

use super::super::{Check, Rule, RuleCx};
use super::read;
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::{FileFacts, View};

pub(crate) static RULE: Rule = Check::File(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "does not put the asset on: its mesh cannot be loaded",
    )],
    docs: include_str!("ngon.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-ngon",
        Level::Error,
        "a face with more than four corners",
    )
});

fn run(view: &View<'_>, file: &FileFacts, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(mesh) = read(view, file) else { return };
    let tally = &mesh.facts.ngons;
    let Some((line, corners)) = tally.first.first() else {
        return;
    };
    let message = match tally.count {
        1 => format!("the face has {corners} corners"),
        count => format!("{count} faces have more than four corners, the first {corners}"),
    };
    let finding = RULE
        .at(file, Place::Line(*line), message)
        .evidence(tally.evidence(mesh.faces));
    let finding = finding.help("split it into triangles or quads, and add no vertices");
    out.push(mesh.weigh(view, file, finding, &[]));
}
