//! Names of bones that the default skeleton does not have.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Rule, RuleCx, did_you_mean, such};
use super::remapped::remapped;
use super::{Rig, rigs};
use mhlint_diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place};
use mhlint_repo::Body;

/// A bone, the member of it, and the name in that.
pub(super) type Unknown<'a> = (&'a str, &'a str, &'a str);

/// One finding for all in a skeleton.
pub(super) fn finding(
    rule: &Rule,
    rig: &Rig<'_>,
    unknown: &[Unknown<'_>],
    known: &BTreeSet<&str>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let (bone, member, name) = unknown.first()?;
    let more = such(unknown.len(), "names");
    let message = format!(
        "`{member}` of bone `{bone}` names `{name}`, which the default skeleton does not have{more}"
    );
    let help = did_you_mean(
        cx.suggestions.nearest(name, known.iter().copied()),
        "name bones of the default skeleton",
    );
    let cases = unknown
        .iter()
        .map(|(bone, _, name)| format!("{bone}: {name}"));
    Some(
        rule.at(rig.file, Place::pointer(["bones", bone, member]), message)
            .help(help)
            .evidence(Evidence::of_cases(cases)),
    )
}

const LEFT_OUT: Case = &[(
    Makehuman1,
    Level::Info,
    "leaves the name out; the bone keeps its other references",
)];
const OTHERS_TAKE: Case = &[(
    Makehuman1,
    Level::Warning,
    "leaves the name out: the weights that are meant go to another bone",
)];

/// Names in `reference` stop `MakeHuman` 1, those in `weights_reference` are left out.
pub(super) fn of_makehuman1(
    rule: &Rule,
    body: &Body<'_>,
    known: &BTreeSet<&str>,
    cx: &RuleCx<'_>,
    out: &mut Vec<Finding>,
) {
    // Bones of the base skeleton that have weights, and that no bone of a skeleton takes.
    let weights = body
        .default_rig()
        .and_then(mhlint_repo::Rig::weights)
        .map(|weights| weights.bones.as_slice());
    let weighted: BTreeSet<&str> = weights
        .unwrap_or_default()
        .iter()
        .filter(|bone| bone.listed > 0)
        .map(|bone| bone.name.as_str())
        .collect();
    let all = remapped(body).into_iter();
    let losing = all.filter(|own| own.untaken.iter().any(|bone| weighted.contains(bone)));
    let losing: BTreeSet<&str> = losing.map(|own| own.rig.file.path.as_str()).collect();
    for rig in rigs(body).filter(|rig| !rig.own.is_default) {
        let is_losing = losing.contains(rig.file.path.as_str());
        let mut found: BTreeMap<u8, Vec<Unknown<'_>>> = BTreeMap::new();
        for bone in &rig.skeleton.bones {
            let stopping = bone
                .references()
                .into_iter()
                .filter(|name| !known.contains(name));
            found
                .entry(0)
                .or_default()
                .extend(stopping.map(|name| (bone.name.as_str(), "reference", name)));
            let (names, is_explicit) = bone.weight_references();
            let own: BTreeSet<&str> = names.iter().copied().collect();
            let has_none = own.is_disjoint(known);
            for name in names
                .iter()
                .filter(|name| is_explicit && !known.contains(**name))
            {
                let near = cx.suggestions.nearest(name, known.iter().copied());
                let is_meant = near.is_some_and(|near| !own.contains(near));
                let rank = if has_none || is_meant || is_losing {
                    1
                } else {
                    2
                };
                found
                    .entry(rank)
                    .or_default()
                    .push((&bone.name, "weights_reference", name));
            }
        }
        for (rank, unknown) in found {
            let finding = finding(rule, &rig, &unknown, known, cx)
                .map(|finding| finding.key(format!("names {rank}")));
            out.extend(finding.map(|finding| match rank {
                0 => finding,
                1 => finding.case(OTHERS_TAKE),
                _ => finding.case(LEFT_OUT),
            }));
        }
    }
}
