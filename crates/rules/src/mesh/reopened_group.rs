//! A face group must be opened once.

use super::super::cause::consequence::UNREAD_MESH;
use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman2, Case, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_formats::obj::{Mesh, Reopened};
use mhlint_repo::{Body, FileFacts};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "puts the faces after the second `g` into the group that was started last",
    )],
    docs: include_str!("reopened_group.md").trim_ascii_end(),
    counts: "faces",
    ..RuleInfo::new(
        "mesh-reopened-group",
        Level::Warning,
        "a face group appears more than once",
    )
});

const VANISHING: Case = &[(
    Makehuman2,
    Level::Error,
    "hides visible faces: they end up in a group that is not shown",
)];

const SHOW_THEM: &str = "give the later faces a new group name, and list it in `visible groups`; \
    do not reorder the faces";
const IF_SEEN: &str = "give the later faces a new group name if they show in the wrong group; \
    among hidden groups leave them as they are";

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = body.obj else { return };
    // An archive that was packed from this OBJ has the faces where it put them.
    let is_in_use = body.mesh.is_some_and(|(_, used)| has_faces_of(used, mesh));
    let is_visible = |group: &str| {
        body.visible_groups
            .is_some_and(|visible| visible.contains(group))
    };
    let vanishes = |group: &&Reopened| {
        is_visible(&group.name) && !group.lands_in.iter().all(|name| is_visible(name))
    };
    let (vanishing, others): (Vec<&Reopened>, Vec<&Reopened>) =
        mesh.facts.reopened.iter().partition(vanishes);
    let weighed = |finding: Finding, case| finding.case(if is_in_use { case } else { UNREAD_MESH });
    if let Some(finding) = finding(file, &vanishing, mesh.faces.len()) {
        out.push(weighed(finding.key("visible").help(SHOW_THEM), VANISHING));
    }
    out.extend(
        finding(file, &others, mesh.faces.len()).map(|finding| weighed(finding.help(IF_SEEN), &[])),
    );
}

/// Whether one mesh has as many faces in each group as another.
fn has_faces_of(one: &Mesh, other: &Mesh) -> bool {
    let faces = |mesh: &'_ Mesh| -> Vec<(String, usize)> {
        let groups = mesh.groups.iter().filter(|group| group.faces > 0);
        groups
            .map(|group| (group.name.clone(), group.faces))
            .collect()
    };
    faces(one) == faces(other)
}

/// One cause: the order in which the exporter wrote the faces.
fn finding(file: &FileFacts, groups: &[&Reopened], faces: usize) -> Option<Finding> {
    let strayed: usize = groups.iter().map(|group| group.strayed).sum();
    let first = groups.iter().find(|group| group.strayed > 0)?;
    let lands_in = first.lands_in.first().map_or("", AsRef::as_ref);
    let message = match groups {
        [only] if strayed == 1 => {
            format!(
                "group `{}` appears more than once: 1 of its faces ends up in `{lands_in}`",
                only.name
            )
        }
        [only] => {
            format!(
                "group `{}` appears more than once: {strayed} of its faces end up in `{lands_in}`",
                only.name
            )
        }
        _ => format!(
            "{} groups appear more than once: {strayed} faces end up elsewhere, first those of \
                `{}` in `{lands_in}`",
            groups.len(),
            first.name
        ),
    };
    let cases = groups.iter().map(|group| {
        format!(
            "{} ({} of {} faces)",
            group.name, group.strayed, group.faces
        )
    });
    let evidence = Evidence::of_groups(cases, strayed as u64).out_of(faces);
    let place = Place::Line(first.line);
    let parts = groups.iter().map(|group| &group.name);
    Some(
        RULE.at(file, place, message)
            .parts(parts)
            .evidence(evidence),
    )
}
