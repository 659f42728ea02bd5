//! A face has each of its vertices once.

use super::super::cause::worn::meshes;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::obj::{Mesh, Repeating};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "creates a triangle without area; if another corner was meant, the surface has a hole",
    )],
    docs: include_str!("degenerate_face.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-degenerate-face",
        Level::Warning,
        "a face uses a vertex twice",
    )
});

const HELP: &str = "write the intended corner, or make the face a triangle";
const HIDDEN: Case = &[(
    Makehuman2,
    Level::Info,
    "never shows the face: its group is not visible",
)];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    out.extend(of_base(body));
    for (_, file, mesh) in meshes(body, |_, mesh| body.opens(mesh)) {
        let Some((first, count)) = &mesh.degenerate else {
            continue;
        };
        let message = match count {
            1 => format!("the face uses {} twice", mesh.named(first.vertex)),
            _ => format!(
                "{count} of {} faces use a vertex twice, first {}",
                mesh.faces,
                mesh.named(first.vertex)
            ),
        };
        let finding = RULE.at(file, Place::Line(first.line), message).help(HELP);
        out.push(finding.evidence(Evidence::counted(*count).out_of(mesh.faces)));
    }
}

fn of_base(body: &Body<'_>) -> Option<Finding> {
    let (file, mesh) = body.mesh?;
    let is_visible = |face: &&Repeating| is_visible(body, mesh, face);
    let (visible, hidden): (Vec<&Repeating>, Vec<&Repeating>) =
        mesh.facts.repeating.iter().partition(is_visible);
    let (told, is_hidden) = if visible.is_empty() {
        (hidden, true)
    } else {
        (visible, false)
    };
    let first = told.first()?;
    let message = match told.len() {
        1 => format!("the face uses {} twice", body.vertex(first.vertex)),
        count => {
            format!(
                "{count} of {} faces use a vertex twice, first {}",
                mesh.faces.len(),
                body.vertex(first.vertex)
            )
        }
    };
    // Packed faces have no lines.
    let (place, told_by): (_, fn(&&Repeating) -> String) = match first.line {
        0 => (Place::File, |face| format!("vertex {}", face.vertex)),
        line => (Place::Line(line), |face| format!("line {}", face.line)),
    };
    let finding = RULE
        .at(file, place, message)
        .help(HELP)
        .parts(told.iter().map(|face| face.vertex))
        .evidence(Evidence::of_unnamed(told.iter().map(told_by)).out_of(mesh.faces.len()));
    Some(if is_hidden {
        finding.case(HIDDEN)
    } else {
        finding
    })
}

fn is_visible(body: &Body<'_>, mesh: &Mesh, face: &Repeating) -> bool {
    let group = mesh.groups.get(face.group as usize);
    group.is_some_and(|group| body.shows(&group.name))
}
