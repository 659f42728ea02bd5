//! The joints at which bones end are vertex groups of the base mesh.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::ends::{AT_DEFAULT, ends, has_place};
use super::{STOPS, at_bones, stops};
use mhlint_diag::{Application::Mpfb, Finding, Grouped, Level, RuleInfo, grouped};
use mhlint_formats::rig::{End, Rig, RigBone, Strategy};
use mhlint_repo::mpfb::{RigFile, View};

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(Mpfb, STOPS)],
    docs: include_str!("unknown_cube.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "rig-unknown-cube",
        Level::Error,
        "a bone ends at a joint that the base mesh does not have",
    )
});

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(groups) = view.groups.filter(|groups| groups.stops.all().is_empty()) else {
        return;
    };
    let names = groups.groups.iter().map(|group| group.name.as_str());
    let joints: BTreeSet<&str> = names.filter(|name| name.contains("joint")).collect();
    // A joint that the mesh has and the table of vertex groups lacks is reported by
    // `metadata-table`.
    let of_mesh = view
        .mesh
        .iter()
        .flat_map(|(_, mesh)| &mesh.groups)
        .map(|group| group.name.as_str());
    let lost: BTreeSet<&str> = of_mesh.filter(|name| name.starts_with("joint-")).collect();
    if joints.is_empty() {
        return;
    }
    let in_lower_case = grouped(joints.iter().map(|name| (name.to_ascii_lowercase(), *name)));
    let known = (&joints, &in_lower_case);
    for (file, rig) in view.own_rigs() {
        let is_unknown = |end: &End| match &end.strategy {
            Strategy::Cube(name) => !joints.contains(&**name) && !lost.contains(&**name),
            _ => false,
        };
        for has_default in [false, true] {
            let found =
                ends(rig).filter(|(.., end)| is_unknown(end) && has_place(end) == has_default);
            let found: Vec<(&RigBone, &'static str, &End)> = found.collect();
            out.extend(finding(file, rig, &found, has_default, known, cx));
        }
    }
}

fn finding(
    file: &RigFile<'_>,
    rig: &Rig,
    found: &[(&RigBone, &'static str, &End)],
    has_default: bool,
    (joints, in_lower_case): (&BTreeSet<&str>, &Grouped<String, &str>),
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (bone, which, end) = found.first()?;
    let Strategy::Cube(name) = &end.strategy else {
        return None;
    };
    let more = such(found.len(), "ends");
    let message = format!(
        "joint `{name}` of `{which}` of bone `{}` does not exist{more}",
        bone.name
    );
    let in_other_case = in_lower_case.get(&name.to_ascii_lowercase());
    let near = in_other_case.and_then(|same| same.first()).copied();
    let near = near.or_else(|| cx.suggestions.nearest(name, joints.iter().copied()));
    let bones: Vec<&str> = found.iter().map(|(bone, ..)| bone.name.as_str()).collect();
    let finding = at_bones(&RULE, file, rig, &bones, which, message)?;
    let finding = finding.help(did_you_mean(
        near,
        "name a joint of the base mesh, `joint-…`",
    ));
    let finding = finding.key(if has_default {
        "default"
    } else {
        "without default"
    });
    Some(if has_default {
        finding.case(AT_DEFAULT)
    } else {
        stops(file, finding)
    })
}
