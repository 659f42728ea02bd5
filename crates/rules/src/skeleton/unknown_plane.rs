//! The plane that a bone names must exist.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx};
use super::measured::plane_of;
use super::{Rig, SINGLE, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_formats::mhskel::Section;
use mhlint_json::UnknownKey;
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (Makehuman2, "rejects the skeleton and logs a line"),
        (Makehuman1, VERTICAL),
    ],
    levels: &[(Makehuman1, Level::Warning)],
    docs: include_str!("unknown_plane.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-unknown-plane",
        Level::Error,
        "a bone names a plane that does not exist",
    )
});

const VERTICAL: &str =
    "turns the bone around its own axis: it takes the vertical in place of the plane";

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // `planes` of another type has a finding of its own.
    let counts = |rig: &Rig<'_>| !body.is_makehuman1() || rig.own.is_default;
    for rig in
        rigs(body).filter(|rig| rig.skeleton.planes_section != Section::Misshapen && counts(rig))
    {
        let known: BTreeSet<&str> = rig
            .skeleton
            .planes
            .iter()
            .map(|plane| plane.name.as_str())
            .collect();
        let unknown: BTreeSet<&str> = rig
            .asked_planes()
            .into_iter()
            .filter(|plane| !known.contains(plane))
            .collect();
        if known.is_empty() && unknown.len() > 1 || unknown.len() > SINGLE {
            out.extend(many(&rig, &unknown, known.is_empty()));
            continue;
        }
        for plane in unknown {
            let bones = bones_with(&rig, |name| name == plane);
            let Some(first) = bones.first() else { continue };
            let message = match bones.len() {
                1 => format!("bone `{first}` names plane `{plane}`, which does not exist"),
                count => format!("{count} bones name plane `{plane}`, which does not exist"),
            };
            let help = match (
                cx.suggestions.nearest(plane, known.iter().copied()),
                misspelt_planes(&rig),
            ) {
                (_, Some(help)) => help,
                (Some(name), None) => format!("did you mean `{name}`?"),
                (None, None) => {
                    "add it to `planes`, or remove `rotation_plane` to use the vertical".to_owned()
                }
            };
            out.push(
                RULE.at(
                    rig.file,
                    Place::pointer(["bones", first, "rotation_plane"]),
                    message,
                )
                .key(plane)
                .help(help)
                .evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len())),
            );
        }
    }
}

/// One finding where the skeleton has none of the planes, or lacks more than anybody mistypes.
fn many(rig: &Rig<'_>, unknown: &BTreeSet<&str>, has_none: bool) -> Option<Finding> {
    let bones = bones_with(rig, |name| unknown.contains(name));
    let first = bones.first()?;
    let (count, planes) = (bones.len(), unknown.len());
    let what = if has_none {
        "planes, but the skeleton has none"
    } else {
        "planes that do not exist"
    };
    let message = format!("{count} bones name {planes} {what}");
    let finding = RULE
        .at(
            rig.file,
            Place::pointer(["bones", first, "rotation_plane"]),
            message,
        )
        .key("planes");
    let help = misspelt_planes(rig);
    let finding = finding.help(help.unwrap_or_else(|| {
        "add the planes to `planes`, or remove `rotation_plane` to use the vertical".to_owned()
    }));
    Some(finding.evidence(Evidence::of_cases(&bones).out_of(rig.skeleton.bones.len())))
}

/// The bones that name one of these planes.
fn bones_with<'a>(rig: &Rig<'a>, is_wanted: impl Fn(&str) -> bool) -> Vec<&'a str> {
    let bones = rig
        .skeleton
        .bones
        .iter()
        .filter(|bone| plane_of(bone).is_some_and(&is_wanted));
    bones.map(|bone| bone.name.as_str()).collect()
}

/// What to do where the planes are there under a misspelt key.
fn misspelt_planes(rig: &Rig<'_>) -> Option<String> {
    let mut unknown = rig
        .file
        .schema
        .unknown
        .iter()
        .filter(|_| rig.skeleton.planes.is_empty());
    let is_planes = |key: &&UnknownKey| {
        key.nearest.as_deref() == Some("planes") && key.pointer == format!("/{}", key.key)
    };
    unknown
        .find(is_planes)
        .map(|key| format!("rename `{}` to `planes`", key.key))
}
