//! Vertex groups that MPFB can read, and that are not what they should be
//! (`docs/loaders/mpfb/base-mesh.md#vertex-groups`).

use std::collections::BTreeSet;

use super::super::{Rule, such};
use mhlint_diag::{Application::Mpfb, Case, Evidence, Finding, Level, Place};
use mhlint_discover::Kind;
use mhlint_formats::mesh_metadata::{BodyDimensions, VertexGroup, VertexGroups};
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::mpfb::View;

const BODY: &str = "body";
const HIDDEN: Case = &[(
    Mpfb,
    Level::Error,
    "hides all of the body: the mask shows no vertex",
)];
const UNMASKED: Case = &[(
    Mpfb,
    Level::Warning,
    "shows all helpers: their mask has no group",
)];
const EMPTY: Case = &[(Mpfb, Level::Warning, "silently leaves the range out")];
const BEYOND: Case = &[(
    Mpfb,
    Level::Warning,
    "silently takes what vertices there are",
)];
const NO_JOINT: Case = &[(
    Mpfb,
    Level::Warning,
    "lets bones that end there end elsewhere",
)];

/// Findings on groups, each sort once.
pub(super) fn faults(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    groups: &VertexGroups,
    out: &mut Vec<Finding>,
) {
    let sound = view
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0 && mesh.facts.vertices > 0);
    let vertices = sound.and_then(|(_, mesh)| i64::try_from(mesh.facts.vertices).ok());
    let is_empty = |group: &VertexGroup| group.is_empty(vertices);
    let at = |group: &str, message: String, key: &str, case: Case| {
        rule.at(file, Place::pointer([group]), message)
            .key(format!("{key} {group}"))
            .case(case)
    };
    let body = groups.groups.iter().find(|group| group.name == BODY);
    match body {
        None => {
            let finding = rule
                .at(file, Place::File, "there is no group `body`")
                .key(BODY)
                .case(UNMASKED);
            out.push(finding.help("add the group with the vertices of the body"));
        }
        Some(body) if is_empty(body) => {
            let finding = at(BODY, "group `body` has no vertex".to_owned(), BODY, HIDDEN);
            out.push(finding.help("write the first vertex before the last one"));
        }
        Some(_) => {}
    }
    let reversed = |group: &&VertexGroup| {
        group.ranges.iter().any(|(first, last)| first > last) && !is_empty(group)
    };
    out.extend(
        told(&groups.groups, reversed).map(|(first, more, evidence)| {
            let message = format!("a range of `{}` ends before it begins{more}", first.name);
            at(&first.name, message, "reversed", EMPTY)
                .help("exchange its numbers")
                .evidence(evidence)
        }),
    );
    let beyond = |group: &&VertexGroup| {
        let is_beyond = |last: i64| vertices.is_some_and(|vertices| last >= vertices);
        group
            .ranges
            .iter()
            .any(|(first, last)| first <= last && is_beyond(*last))
            && !is_empty(group)
    };
    out.extend(told(&groups.groups, beyond).map(|(first, more, evidence)| {
        let count = vertices.unwrap_or_default();
        let message = format!(
            "`{}` reaches beyond the mesh, which has {count} vertices{more}",
            first.name
        );
        at(&first.name, message, "beyond", BEYOND)
            .help("correct the ends of its ranges")
            .evidence(evidence)
    }));
    out.extend(lost_joints(rule, view, file, groups));
}

const UNREAD: Case = &[(
    Mpfb,
    Level::Info,
    "has no effect in MPFB, which never reads these names",
)];

/// Names of groups in the dimensions of the body that lead nowhere.
pub(super) fn unknown(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    named: &BodyDimensions,
) -> Option<Finding> {
    let groups = view
        .layers
        .system?
        .files
        .values()
        .find(|file| file.kind == Kind::VertexGroups)?;
    let groups = groups
        .vertex_groups()
        .filter(|groups| groups.stops.all().is_empty())?;
    let known: BTreeSet<&str> = groups
        .groups
        .iter()
        .map(|group| group.name.as_str())
        .collect();
    let unknown = named
        .groups
        .iter()
        .filter(|one| !known.contains(&*one.name))
        .map(|one| (one, "is not a vertex group"));
    let without_range = named
        .without_range
        .iter()
        .filter(|one| known.contains(&*one.name));
    let all: Vec<(&NamedAt, &str)> = unknown
        .chain(without_range.map(|one| (one, "has no range")))
        .collect();
    let (first, what) = all.first()?;
    let message = format!("`{}` {what}{}", first.name, such(all.len(), "names"));
    let finding = rule
        .at(file, Place::Pointer(first.pointer.clone()), message)
        .key("names")
        .case(UNREAD);
    let finding = finding.help("correct the names, or remove them");
    Some(finding.evidence(Evidence::of_cases(
        all.iter().map(|(one, _)| one.name.as_str()),
    )))
}

/// Joints of the mesh without a group.
fn lost_joints(
    rule: &Rule,
    view: &View<'_>,
    file: &FileFacts,
    groups: &VertexGroups,
) -> Option<Finding> {
    let (_, mesh) = view.mesh?;
    let known: BTreeSet<&str> = groups
        .groups
        .iter()
        .map(|group| group.name.as_str())
        .collect();
    let joints: BTreeSet<&str> = mesh
        .groups
        .iter()
        .map(|group| group.name.as_str())
        .collect();
    let lost: Vec<&str> = joints
        .into_iter()
        .filter(|name| name.starts_with("joint-") && !known.contains(name))
        .collect();
    let message = format!(
        "joint `{}` of `base.obj` has no group{}",
        lost.first()?,
        such(lost.len(), "joints")
    );
    let finding = rule
        .at(file, Place::File, message)
        .key("joints")
        .case(NO_JOINT);
    Some(
        finding
            .evidence(Evidence::of_cases(lost))
            .help("add the group, or correct its name"),
    )
}

/// The first of the groups that are so, how many there are, and all of them.
fn told<'g>(
    groups: &'g [VertexGroup],
    is_so: impl Fn(&&'g VertexGroup) -> bool,
) -> Option<(&'g VertexGroup, String, mhlint_diag::Cases)> {
    let all: Vec<&VertexGroup> = groups.iter().filter(is_so).collect();
    let first = *all.first()?;
    Some((
        first,
        such(all.len(), "groups"),
        Evidence::of_cases(all.iter().map(|group| group.name.as_str())),
    ))
}
