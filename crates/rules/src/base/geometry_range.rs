//! The ranges of `geometry.json` must be those of the mesh.

use std::collections::BTreeMap;

use super::super::cause::consequence::{NEVER_OPENED, is_opened_by_scripts};
use super::super::{Check, Rule, RuleCx, counted, did_you_mean};
use mhlint_diag::{
    Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo, Suggestions,
};
use mhlint_formats::Content;
use mhlint_formats::geometry::{Geometry, Range};
use mhlint_formats::obj::{DEFAULT_GROUP, Group, Mesh};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

const GEOMETRY: &str = "geometry-ranges";
const JOINTS: &str = "joint-ranges";
/// What the OBJ puts before the name of a joint.
const PREFIX: &str = "joint-";

pub(crate) static RULE: Rule = Check::Makehuman2(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "moves the wrong vertices, or none, when its scripts align joint cubes",
    )],
    docs: include_str!("geometry_range.md").trim_ascii_end(),
    counts: "ranges",
    ..RuleInfo::new(
        "base-geometry-range",
        Level::Info,
        "a range in `geometry.json` differs from the mesh",
    )
});

fn run(view: &View<'_>, base: &Base<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(file) = view
        .layers
        .first_existing(&format!("base/{}/geometry.json", base.name))
    else {
        return;
    };
    let (Content::Geometry(geometry), Some((_, mesh))) = (&*file.content, base.mesh) else {
        return;
    };
    if mesh.facts.unreadable_lines > 0 {
        return;
    }
    let found = faults(file, base, geometry, mesh, &cx.suggestions);
    if is_opened_by_scripts(&file.rel) {
        out.extend(found);
    } else {
        out.extend(never_opened(found));
    }
}

fn faults(
    file: &FileFacts,
    base: &Base<'_>,
    geometry: &Geometry,
    mesh: &Mesh,
    suggestions: &Suggestions,
) -> Vec<Finding> {
    let mut groups: BTreeMap<&str, &Group> = BTreeMap::new();
    for group in &mesh.groups {
        groups.entry(&group.name).or_insert(group);
    }
    let has_joints = groups.keys().any(|name| name.starts_with(PREFIX));
    if !has_joints && geometry.joint_ranges.len() > 1 {
        return without_joints(file, base, &geometry.joint_ranges, mesh)
            .into_iter()
            .collect();
    }
    // Which groups are mixed only the OBJ can tell; an archive has the faces where it put them.
    let mixed = base.obj().map(|(_, obj)| obj.facts.mixed_groups());
    // Vertices that do not exist make a group look larger than it is.
    let is_plain = |group: &&Group| {
        mesh.facts.face_out_of_range.count == 0
            && mixed
                .as_ref()
                .is_some_and(|mixed| !mixed.contains(group.name.as_str()))
    };
    let joints = geometry.joint_ranges.iter().filter_map(|range| {
        let name = format!("{PREFIX}{}", range.name);
        match groups.get(name.as_str()).copied() {
            None => Some(without_group(file, range, mesh, suggestions)),
            found => unlike(file, (JOINTS, range), mesh, found.filter(is_plain)),
        }
    });
    // Parts may be made of several groups; only a group of the same name can be compared.
    let parts = geometry.geometry_ranges.iter().filter_map(|range| {
        let found = groups.get(range.name.as_str()).copied();
        unlike(file, (GEOMETRY, range), mesh, found.filter(is_plain))
    });
    joints.chain(parts).collect()
}

/// All that is wrong with a file that nothing opens.
fn never_opened(found: Vec<Finding>) -> Option<Finding> {
    let keys: Vec<String> = found
        .iter()
        .map(|finding| finding.subject.key.clone())
        .collect();
    let mut first = found.into_iter().next()?;
    if keys.len() > 1 {
        first.message = format!("{} wrong ranges, first: {}", keys.len(), first.message);
        first = first.help("correct the ranges, or remove the file");
    }
    Some(
        first
            .key("ranges")
            .effect(NEVER_OPENED)
            .evidence(Evidence::of_cases(&keys)),
    )
}

/// A mesh without any joint group: one fault of the mesh. Where it has no group at all and another
/// is to be shown, `base-unknown-equipment` says so.
fn without_joints(
    file: &FileFacts,
    base: &Base<'_>,
    ranges: &[Range],
    mesh: &Mesh,
) -> Option<Finding> {
    let first = ranges.first()?;
    let shown = base
        .settings()
        .and_then(|(_, settings)| settings.shown.as_ref());
    let is_shown = |group: &String| shown.is_some_and(|shown| shown.contains(group));
    let is_told = mesh
        .groups
        .iter()
        .all(|group| group.name == DEFAULT_GROUP && !is_shown(&group.name));
    let message = format!(
        "{}, but the mesh has no `{PREFIX}…` groups",
        counted(ranges.len(), "joint range")
    );
    let names = ranges.iter().map(|range| &range.name);
    let finding = RULE
        .at(file, Place::key([JOINTS, &first.name]), message)
        .key(JOINTS);
    let finding = finding.help("export the mesh with its groups, or remove the ranges");
    (!is_told).then(|| finding.evidence(Evidence::of_cases(names).out_of(ranges.len())))
}

fn without_group(
    file: &FileFacts,
    range: &Range,
    mesh: &Mesh,
    suggestions: &Suggestions,
) -> Finding {
    let groups = suggestions.looked_through(&mesh.groups);
    let joints = groups.filter_map(|group| group.name.strip_prefix(PREFIX));
    let help = did_you_mean(
        suggestions.nearest(&range.name, joints),
        "use the name of a mesh group, without `joint-`",
    );
    let message = format!(
        "`{}` has no group `{PREFIX}{}` in the mesh",
        range.name, range.name
    );
    RULE.at(file, Place::key([JOINTS, &range.name]), message)
        .key(format!("{JOINTS} {}", range.name))
        .help(help)
}

fn unlike(
    file: &FileFacts,
    (section, range): (&str, &Range),
    mesh: &Mesh,
    group: Option<&Group>,
) -> Option<Finding> {
    let (first, last) = range.ends?;
    let at = |message: String| {
        let place = Place::pointer([section, &range.name]);
        RULE.at(file, place, message)
            .key(format!("{section} {}", range.name))
    };
    let vertices = i64::try_from(mesh.facts.vertices).unwrap_or(i64::MAX);
    if first > last || first < 0 || last >= vertices {
        let message = format!(
            "`{}` covers vertices {first} to {last}, but the mesh has {vertices} vertices",
            range.name
        );
        return Some(
            at(message).help("write the first and the last vertex of the part, counted from 0"),
        );
    }
    let (lowest, highest) = group?.vertices?;
    if (i64::from(lowest), i64::from(highest)) == (first, last) {
        return None;
    }
    let message = format!(
        "`{}` covers vertices {first} to {last}, but its group covers {lowest} to {highest}",
        range.name
    );
    Some(at(message).help(format!(
        "write {lowest} as the first vertex and {highest} as the last"
    )))
}
