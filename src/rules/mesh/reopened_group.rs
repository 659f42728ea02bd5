//! A face group must be opened once.

use super::super::cause::consequence::UNREAD_MESH;
use super::super::{Check, Rule, RuleCx};
use crate::diag::{Application, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::obj::{Mesh, Reopened};
use crate::repo::{Body, FileFacts};

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(
            Application::Makehuman2,
            "leaves the faces behind the second `g` in the group that was opened last",
        )],
        docs: "In an OBJ file `g name` starts a group, or continues one that was started before.\n\nMakeHuman 2 \
            understands the start only. After the second `g` of a name the faces stay in the group that was \
            opened last before it. Among invisible helpers this is hardly noticed; faces of a group that \
            `base.json` shows (`visible groups`) vanish when they end up in one that is not shown \
            (`error`). An archive (`base.mhbin`) that was packed from the OBJ has them there as well; one that was packed before harms \
            nobody today (an info).\n\nSort the faces so that each group comes once; exporters have an option for it.",
        ..RuleInfo::new("mesh-reopened-group", Level::Warning, "a face group is opened a second time")
    },
    check: Check::Body(run),
};

const VANISHING: Case =
    &[(Application::Makehuman2, Level::Error, "loses visible faces: they end up in a group that is not shown")];

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some((file, mesh)) = body.obj else { return };
    // An archive that was packed from this OBJ has the faces where it put them.
    let is_in_use = body.mesh.is_some_and(|(_, used)| has_faces_of(used, mesh));
    let is_visible = |group: &str| body.visible_groups.is_some_and(|visible| visible.contains(group));
    let vanishes = |group: &&Reopened| is_visible(&group.name) && !group.lands_in.iter().all(|name| is_visible(name));
    let (vanishing, others): (Vec<&Reopened>, Vec<&Reopened>) = mesh.facts.reopened.iter().partition(vanishes);
    let weighed = |finding: Finding, case| finding.case(if is_in_use { case } else { UNREAD_MESH });
    if let Some(finding) = finding(file, &vanishing, mesh.faces.len()) {
        out.push(weighed(finding.key("visible"), VANISHING));
    }
    out.extend(finding(file, &others, mesh.faces.len()).map(|finding| weighed(finding, &[])));
}

/// Whether one mesh has as many faces in each group as another.
fn has_faces_of(one: &Mesh, other: &Mesh) -> bool {
    let faces = |mesh: &'_ Mesh| -> Vec<(String, usize)> {
        let groups = mesh.groups.iter().filter(|group| group.faces > 0);
        groups.map(|group| (group.name.clone(), group.faces)).collect()
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
            format!("group `{}` is opened again: 1 of its faces ends up in `{lands_in}`", only.name)
        }
        [only] => format!("group `{}` is opened again: {strayed} of its faces end up in `{lands_in}`", only.name),
        _ => format!(
            "{} groups are opened again: {strayed} faces end up in another group, the first ones of `{}` in `{lands_in}`",
            groups.len(),
            first.name
        ),
    };
    let cases = groups.iter().map(|group| format!("{} ({} of {} faces)", group.name, group.strayed, group.faces));
    let evidence = Evidence::of_groups(cases, strayed as u64).out_of(faces);
    let place = Place::Line(first.line);
    let parts = groups.iter().map(|group| &group.name);
    Some(
        RULE.at(file, place, message)
            .parts(parts)
            .help(
                "leave it where both groups are hidden, as nothing shows; otherwise give the later faces a group name of \
                 their own",
            )
            .evidence(evidence),
    )
}
