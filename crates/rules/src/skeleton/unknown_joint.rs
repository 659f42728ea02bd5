//! Joints that bones and planes name must exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::joint_or_group::unknown_joints;
use super::{Rig, SINGLE, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhskel::Section;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `KeyError` when the skeleton is chosen, for the default skeleton while \
                loading the base mesh",
        ),
        (
            Makehuman1,
            "puts the end of the bone at the origin, with a line in the log",
        ),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("unknown_joint.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-unknown-joint",
        Level::Error,
        "a bone or its plane names a joint \
        that does not exist",
    )
});

const STOPS: Case = &[(Makehuman2, Level::Error, "crashes with `KeyError`")];

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_makehuman1() {
        return unknown_joints(&RULE, body, cx, out);
    }
    for rig in rigs(body).filter(|rig| rig.skeleton.joints_section == Section::Present) {
        let known: BTreeSet<&str> = rig
            .skeleton
            .joints
            .iter()
            .map(|joint| joint.name.as_str())
            .collect();
        if known.is_empty() && uses(&rig).len() > 1 {
            out.extend(without_joints(&rig));
            continue;
        }
        let unknown: BTreeMap<_, _> = uses(&rig)
            .into_iter()
            .filter(|(joint, _)| !known.contains(joint))
            .collect();
        if unknown.len() > SINGLE {
            out.extend(many(&rig, &unknown, &known));
            continue;
        }
        for (joint, uses) in unknown {
            let Some((place, owner)) = uses.first() else {
                continue;
            };
            let message = match uses.len() {
                1 => format!("{owner} names joint `{joint}`, which does not exist"),
                count => {
                    format!("{owner} names joint `{joint}`, which does not exist ({count} uses)")
                }
            };
            let help = did_you_mean(
                cx.suggestions.nearest(joint, known.iter().copied()),
                "add it to `joints`, or name an existing joint",
            );
            let finding = RULE
                .at(rig.file, place.clone(), message)
                .key(joint)
                .help(help);
            let finding = finding.evidence(Evidence::of_cases(uses.iter().map(|(_, owner)| owner)));
            out.push(rig.stops_with(STOPS, finding));
        }
    }
}

/// One finding for more joints than anybody mistypes.
fn many(
    rig: &Rig<'_>,
    unknown: &BTreeMap<&str, Vec<(Place, String)>>,
    known: &BTreeSet<&str>,
) -> Option<Finding> {
    let (first, uses) = unknown.first_key_value()?;
    let (place, _) = uses.first()?;
    let message = format!(
        "bones and planes name {} joints that do not exist, such as `{first}`",
        unknown.len()
    );
    let help = match other_beginning(unknown.keys().copied(), known) {
        Some((with, "")) => {
            format!("add the prefix `{with}` to the names, as in `joints`")
        }
        Some((_, without)) => {
            format!("remove the prefix `{without}` from the names, as in `joints`")
        }
        None => "name existing joints; check that `joints` is not from another skeleton".to_owned(),
    };
    let finding = RULE
        .at(rig.file, place.clone(), message)
        .key("joints")
        .help(help);
    Some(rig.stops_with(
        STOPS,
        finding.evidence(Evidence::of_cases(unknown.keys()).out_of(self::uses(rig).len())),
    ))
}

/// What the joints have in front of these names, and what the names have in front of the joints,
/// where that is all that differs.
fn other_beginning<'n>(
    names: impl Iterator<Item = &'n str> + Clone,
    known: &BTreeSet<&'n str>,
) -> Option<(&'n str, &'n str)> {
    let first = names.clone().next()?;
    let differs = |joint: &&'n str| {
        joint
            .strip_suffix(first)
            .map(|with| (with, ""))
            .or_else(|| first.strip_suffix(*joint).map(|own| ("", own)))
    };
    known.iter().filter_map(differs).find(|(with, without)| {
        names.clone().all(|name| {
            name.strip_prefix(without)
                .is_some_and(|rest| known.contains(format!("{with}{rest}").as_str()))
        })
    })
}

/// One finding where the skeleton has no joint at all.
fn without_joints(rig: &Rig<'_>) -> Option<Finding> {
    let uses = uses(rig);
    let (place, _) = uses.values().flatten().next()?;
    let message = format!(
        "bones and planes name {} joints, but `joints` is empty",
        uses.len()
    );
    let finding = RULE
        .at(rig.file, place.clone(), message)
        .key("joints")
        .help("add the joints to `joints`");
    let finding = finding.evidence(Evidence::of_cases(uses.keys()));
    Some(rig.stops_with(STOPS, finding))
}

/// Joints that are looked up, with the places that name them.
fn uses<'a>(rig: &Rig<'a>) -> BTreeMap<&'a str, Vec<(Place, String)>> {
    let mut uses: BTreeMap<&str, Vec<(Place, String)>> = BTreeMap::new();
    for bone in &rig.skeleton.bones {
        for (member, joint) in [("head", &bone.head), ("tail", &bone.tail)] {
            let Some(joint) = joint else { continue };
            let place = Place::pointer(["bones", &bone.name, member]);
            uses.entry(joint)
                .or_default()
                .push((place, format!("`{member}` of bone `{}`", bone.name)));
        }
    }
    let planes = rig.asked_planes();
    for plane in rig
        .skeleton
        .planes
        .iter()
        .filter(|plane| planes.contains(plane.name.as_str()))
    {
        for (index, joint) in plane.joints.iter().flatten().take(3).enumerate() {
            let Some(joint) = joint else { continue };
            let place = Place::pointer(["planes", &plane.name, &index.to_string()]);
            uses.entry(joint)
                .or_default()
                .push((place, format!("plane `{}`", plane.name)));
        }
    }
    uses
}
