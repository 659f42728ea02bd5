//! Ends of bones of MakeHuman 1: joints of the skeleton, groups of the mesh, or the origin.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, RuleCx, did_you_mean, such};
use super::rigs;
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place};
use mhlint_repo::Body;

const SINGULAR: Case = &[(
    Makehuman1,
    Level::Error,
    "fails with `LinAlgError` when the skeleton is chosen: both ends of a bone are at the origin",
)];

/// Groups of the mesh are joints as well, and one that is nowhere is the origin.
pub(super) fn unknown_joints(
    rule: &Rule,
    body: &Body<'_>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    let Some((_, mesh)) = body.mesh else { return };
    let groups: BTreeSet<&str> = mesh
        .groups
        .iter()
        .map(|group| group.name.as_str())
        .collect();
    // A mesh without any is told itself.
    if !groups.iter().any(|group| group.starts_with("joint-")) {
        return;
    }
    for rig in rigs(body) {
        let own: BTreeSet<&str> = rig
            .skeleton
            .joints
            .iter()
            .map(|joint| joint.name.as_str())
            .collect();
        let is_known = |name: &str| {
            own.contains(name)
                || groups.contains(name)
                || groups.contains(&*format!("joint-{name}"))
        };
        let mut unknown: BTreeMap<&str, Vec<(Place, String)>> = BTreeMap::new();
        let mut is_singular = false;
        let parents: BTreeSet<&str> = rig
            .skeleton
            .bones
            .iter()
            .filter_map(|bone| bone.parent.as_deref())
            .collect();
        for bone in &rig.skeleton.bones {
            let ends = [("head", &bone.head), ("tail", &bone.tail)];
            let lost = ends
                .into_iter()
                .filter_map(|(end, name)| Some((end, name.as_deref()?)));
            let lost: Vec<(&str, &str)> = lost
                .filter(|(_, name)| !name.is_empty() && !is_known(name))
                .collect();
            is_singular |= lost.len() == 2 && parents.contains(bone.name.as_str());
            for (end, name) in lost {
                let place = Place::pointer(["bones", &bone.name, end]);
                unknown
                    .entry(name)
                    .or_default()
                    .push((place, format!("`{end}` of bone `{}`", bone.name)));
            }
        }
        let Some((joint, uses)) = unknown.iter().next() else {
            continue;
        };
        let Some((place, owner)) = uses.first() else {
            continue;
        };
        let more = such(unknown.len(), "joints");
        let message = format!(
            "{owner} names joint `{joint}`, which is neither in `joints` nor a group of the \
                mesh{more}"
        );
        let near = cx
            .suggestions
            .nearest(joint, own.iter().chain(&groups).copied());
        let finding = rule
            .at(rig.file, place.clone(), message)
            .key("joints")
            .parts(unknown.keys().copied());
        let finding = finding.help(did_you_mean(
            near,
            "add it to `joints`, or name an existing joint",
        ));
        let finding = finding.evidence(Evidence::of_cases(unknown.keys()));
        out.push(if is_singular {
            finding.case(SINGULAR)
        } else {
            finding
        });
    }
}

/// Names by which ends of bones may ask for groups of the mesh.
pub(super) fn joints_of_mesh<'v>(body: &Body<'v>) -> BTreeSet<&'v str> {
    let groups = body.mesh.into_iter().flat_map(|(_, mesh)| &mesh.groups);
    let names = groups.map(|group| group.name.as_str());
    names
        .flat_map(|name| [Some(name), name.strip_prefix("joint-")])
        .flatten()
        .collect()
}
