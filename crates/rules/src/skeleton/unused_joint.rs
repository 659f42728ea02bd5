//! Joints that nothing uses.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::hierarchy::hierarchy;
use super::rigs;
use mhlint_diag::{Application::Makehuman2, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_eval::side;
use mhlint_formats::mhskel::Section;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(Makehuman2, "ignores joints that nothing uses")],
    docs: include_str!("unused_joint.md").trim_ascii_end(),
    counts: "joints",
    ..RuleInfo::new(
        "skeleton-unused-joint",
        Level::Info,
        "no bone or plane uses a joint",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    for rig in rigs(body).filter(|rig| rig.skeleton.bones_section == Section::Present) {
        let mut used = rig.asked_joints();
        let joints: BTreeSet<&str> = rig
            .skeleton
            .joints
            .iter()
            .map(|joint| joint.name.as_str())
            .collect();
        // A joint that is asked for under a name that does not exist may be the one that seems
        // unused.
        if rig.skeleton.bones.is_empty() || !used.is_subset(&joints) {
            continue;
        }
        let corners = rig
            .skeleton
            .planes
            .iter()
            .flat_map(|plane| plane.joints.iter().flatten());
        used.extend(corners.filter_map(Option::as_deref));
        let filled = rig
            .skeleton
            .joints
            .iter()
            .filter(|joint| joint.listed > 0)
            .map(|joint| joint.name.as_str());
        // Joints named after a bone that is missing where others name it as their parent were that
        // bone's.
        let missing = hierarchy(rig.skeleton).unknown_parents;
        let missing: BTreeSet<&str> = missing.into_keys().collect();
        let mut ends: BTreeMap<&str, usize> = BTreeMap::new();
        for end in rig
            .skeleton
            .bones
            .iter()
            .flat_map(|bone| [&bone.head, &bone.tail])
            .flatten()
        {
            *ends.entry(end).or_default() += 1;
        }
        let unused = filled.filter(|name| !used.contains(name) && !begins_with_one(&missing, name));
        let unused: Vec<&str> = unused
            .filter(|name| !has_busy_partner(&ends, name))
            .collect();
        let Some(first) = unused.first() else {
            continue;
        };
        // A bone with one joint for both ends has a finding of its own, and lost the other one.
        let doubled = rig
            .skeleton
            .bones
            .iter()
            .filter(|bone| bone.head.is_some() && bone.head == bone.tail);
        if unused.len() <= doubled.count() {
            continue;
        }
        let message = match unused.len() {
            1 => format!("no bone or plane uses joint `{first}`"),
            count => format!(
                "{count} of {} joints are not used by any bone or plane, first `{first}`",
                joints.len()
            ),
        };
        out.push(
            RULE.at(rig.file, Place::key(["joints", first]), message)
                .help("remove the joint, or name it in the bone that should use it")
                .evidence(Evidence::of_cases(&unused).out_of(joints.len())),
        );
    }
}

/// Whether a name begins with one of several others. One that is not the beginning of the name is
/// followed by it from the first letter on in which they differ, and every shorter beginning comes
/// before both.
fn begins_with_one(others: &BTreeSet<&str>, name: &str) -> bool {
    let mut left = name;
    while let Some(other) = others
        .range(..=left)
        .next_back()
        .filter(|own| !own.is_empty())
    {
        let same = left.chars().zip(other.chars());
        let same = same.take_while(|(one, other)| one == other);
        let end: usize = same.map(|(one, _)| one.len_utf8()).sum();
        if end == other.len() {
            return true;
        }
        left = left.get(..end).unwrap_or_default();
    }
    false
}

/// Whether several bones begin or end at the joint of the other side: one of them was meant for
/// this one, and lies on the wrong side (`skeleton-wrong-side`).
fn has_busy_partner(ends: &BTreeMap<&str, usize>, joint: &str) -> bool {
    let ends = |joint: &str| ends.get(joint).copied().unwrap_or(0);
    ends(joint) == 0 && side::of_bone(joint).is_some_and(|(_, partner)| ends(&partner) > 1)
}
