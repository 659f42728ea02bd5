//! The ranges of `geometry.json` must be those of the mesh.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use crate::diag::{Application, Evidence, Finding, Level, Place, RuleInfo, nearest};
use crate::formats::Content;
use crate::formats::geometry::Range;
use crate::formats::obj::{DEFAULT_GROUP, Group, Mesh};
use crate::repo::FileFacts;
use crate::repo::makehuman2::{Base, View};

const GEOMETRY: &str = "geometry-ranges";
const JOINTS: &str = "joint-ranges";
/// What the OBJ puts before the name of a joint.
const PREFIX: &str = "joint-";

pub(in crate::rules) static RULE: Rule = Rule {
    info: RuleInfo {
        breaks: &[(Application::Makehuman2, "aligns the wrong vertices, or none, with its scripts for joint cubes")],
        docs: "`geometry.json` repeats which vertices of the OBJ belong to a part (`geometry-ranges`) and to a joint cube (`joint-ranges`, \
            the group's name without `joint-`).\n\nMakeHuman 2 itself never reads it, but the scripts that align joint cubes move exactly \
            these vertices. A joint without a group of that name, or a range unlike the group's, moves the wrong ones.\n\n\
            Correct the name or the range.",
        ..RuleInfo::new("base-geometry-range", Level::Warning, "`geometry.json` differs from the groups of the mesh")
    },
    check: Check::Makehuman2(run),
};

fn run(view: &View<'_>, base: &Base<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(file) = view.layers.first_existing(&format!("base/{}/geometry.json", base.name)) else { return };
    let (Content::Geometry(geometry), Some((_, mesh))) = (&*file.content, base.mesh) else { return };
    if mesh.facts.unreadable_lines > 0 {
        return;
    }
    if !mesh.groups.iter().any(|group| group.name.starts_with(PREFIX)) && geometry.joint_ranges.len() > 1 {
        return out.extend(without_joints(file, base, &geometry.joint_ranges, mesh));
    }
    for range in &geometry.joint_ranges {
        let group = format!("{PREFIX}{}", range.name);
        let found = mesh.groups.iter().find(|other| other.name == group);
        out.extend(match found {
            None => Some(without_group(file, range, mesh)),
            Some(found) => unlike(file, base, (JOINTS, range), mesh, Some(found)),
        });
    }
    for range in &geometry.geometry_ranges {
        // Parts may be made of several groups; only a group of the same name can be compared.
        let found = mesh.groups.iter().find(|other| other.name == range.name);
        out.extend(unlike(file, base, (GEOMETRY, range), mesh, found));
    }
}

/// A mesh without any joint group: one fault of the mesh. Where it has no group at all and another is to be shown,
/// `base-unknown-equipment` says so.
fn without_joints(file: &FileFacts, base: &Base<'_>, ranges: &[Range], mesh: &Mesh) -> Option<Finding> {
    let first = ranges.first()?;
    let shown = base.settings().and_then(|(_, settings)| settings.visible_groups.as_deref()).unwrap_or_default();
    let is_told = mesh.groups.iter().all(|group| group.name == DEFAULT_GROUP && !shown.contains(&group.name));
    let message = format!("the mesh has no group `{PREFIX}…` at all, and {} ranges are for one", ranges.len());
    let names = ranges.iter().map(|range| &range.name);
    let finding = RULE.at(file, Place::key([JOINTS, &first.name]), message).key(JOINTS);
    let finding = finding.help("export the mesh with its groups, or remove the ranges");
    (!is_told).then(|| finding.evidence(Evidence::of_cases(names).out_of(ranges.len())))
}

fn without_group(file: &FileFacts, range: &Range, mesh: &Mesh) -> Finding {
    let joints = mesh.groups.iter().filter_map(|group| group.name.strip_prefix(PREFIX));
    let help = did_you_mean(nearest(&range.name, joints), "name a group of the mesh without `joint-`");
    let message = format!("the mesh has no group `{PREFIX}{}`", range.name);
    RULE.at(file, Place::key([JOINTS, &range.name]), message).key(format!("{JOINTS} {}", range.name)).help(help)
}

fn unlike(
    file: &FileFacts,
    base: &Base<'_>,
    (section, range): (&str, &Range),
    mesh: &Mesh,
    group: Option<&Group>,
) -> Option<Finding> {
    let (first, last) = range.ends?;
    let at = |message: String| {
        let place = Place::pointer([section, &range.name]);
        RULE.at(file, place, message).key(format!("{section} {}", range.name))
    };
    let vertices = i64::try_from(mesh.facts.vertices).unwrap_or(i64::MAX);
    if first > last || first < 0 || last >= vertices {
        let message = format!("`{}` covers {first} to {last}, but the mesh has {vertices} vertices", range.name);
        return Some(at(message).help("a range is the first and the last vertex, counted from 0"));
    }
    // Faces with vertices that do not exist make a group look larger than it is; they are reported for themselves.
    let group = group.filter(|group| mesh.facts.face_out_of_range.count == 0 && !is_mixed(base, &group.name))?;
    let (lowest, highest) = group.vertices.map(|(lowest, highest)| (i64::from(lowest), i64::from(highest)))?;
    if (lowest, highest) == (first, last) {
        return None;
    }
    let message =
        format!("`{}` covers {first} to {last}, but its group has the vertices {lowest} to {highest}", range.name);
    Some(at(message).help(format!("write {lowest} and {highest}")))
}

/// Whether the application puts faces of another group into this one, or the reverse. An archive has them where it put
/// them; which ones these are only its OBJ can tell.
fn is_mixed(base: &Base<'_>, group: &str) -> bool {
    base.obj().is_none_or(|(_, obj)| {
        let mut reopened = obj.facts.reopened.iter();
        reopened.any(|reopened| reopened.name == group || reopened.lands_in.iter().any(|name| name == group))
    })
}
