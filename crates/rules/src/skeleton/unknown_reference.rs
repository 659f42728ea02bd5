//! Referenced bones must exist in the default skeleton.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean, such};
use super::remapped::remapped;
use super::{Rig, rigs};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{self as repo, Body};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "ignores these names; the bone gets weights and poses from its other \
            references, if any",
        ),
        (
            Makehuman1,
            "fails with `KeyError` when the skeleton is chosen",
        ),
    ],
    levels: &[(Makehuman1, Level::Error)],
    docs: include_str!("unknown_reference.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-unknown-reference",
        Level::Warning,
        "a bone refers to bones that the default skeleton does not have",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(default) = body.default_rig() else {
        return;
    };
    let Some(pose) = default.skeleton() else {
        return;
    };
    let known: BTreeSet<&str> = pose.bones.iter().map(|bone| bone.name.as_str()).collect();
    if known.is_empty() {
        return;
    }
    if body.is_makehuman1() {
        return of_makehuman1(body, &known, cx, out);
    }
    for rig in rigs(body) {
        let (mut unknown, mut spelled) = (Vec::new(), Vec::new());
        for bone in &rig.skeleton.bones {
            for (member, names) in [
                ("reference", &bone.reference),
                ("weights_reference", &bone.weights_reference),
            ] {
                let text = bone.text_references.iter().find(|(key, _)| *key == member);
                let names: Vec<&String> = names
                    .iter()
                    .flatten()
                    .filter(|name| !known.contains(name.as_str()))
                    .collect();
                match text {
                    Some((_, text)) if !names.is_empty() => {
                        spelled.push((bone.name.as_str(), member, text.as_str()));
                    }
                    Some(_) => {}
                    None => unknown.extend(
                        names
                            .into_iter()
                            .map(|name| (bone.name.as_str(), member, name.as_str())),
                    ),
                }
            }
        }
        let found = spelled_out(&rig, &spelled, &known)
            .into_iter()
            .chain(finding(&rig, &unknown, &known, cx));
        // Others refer to the default skeleton; what it refers to itself is never read.
        let is_default = std::ptr::eq(rig.file, default.file);
        out.extend(found.map(|one| {
            if is_default {
                one.case(OF_DEFAULT)
            } else {
                one
            }
        }));
    }
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

/// Names in `reference` stop it, those in `weights_reference` are left out.
fn of_makehuman1(body: &Body<'_>, known: &BTreeSet<&str>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // Bones of the base skeleton that have weights, and that no bone of a skeleton takes.
    let weights = body
        .default_rig()
        .and_then(repo::Rig::weights)
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
        let mut found: BTreeMap<u8, Vec<(&str, &str, &str)>> = BTreeMap::new();
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
            let finding = finding(&rig, &unknown, known, cx)
                .map(|finding| finding.key(format!("names {rank}")));
            out.extend(finding.map(|finding| match rank {
                0 => finding,
                1 => finding.case(OTHERS_TAKE),
                _ => finding.case(LEFT_OUT),
            }));
        }
    }
}

const OF_DEFAULT: Case = &[(
    Makehuman2,
    Level::Info,
    "never reads references in the default skeleton",
)];

/// Texts in place of lists. What writes one writes all of them so.
fn spelled_out(
    rig: &Rig<'_>,
    texts: &[(&str, &str, &str)],
    known: &BTreeSet<&str>,
) -> Option<Finding> {
    let (bone, member, text) = texts.first()?;
    let more = such(texts.len(), "strings");
    let message = format!(
        "`{member}` of bone `{bone}` is the string `{text}`, which is read letter by letter{more}"
    );
    let finding = RULE
        .at(rig.file, Place::pointer(["bones", bone, member]), message)
        .key("strings");
    let cases = texts
        .iter()
        .map(|(bone, member, _)| format!("{bone}/{member}"));
    let finding = finding
        .parts(cases.clone())
        .evidence(Evidence::of_cases(cases).out_of(rig.skeleton.bones.len()));
    let help = if known.contains(text) {
        format!("write a list: `[\"{text}\"]`")
    } else {
        "write a list with names of bones of the default skeleton".to_owned()
    };
    Some(finding.help(help))
}

fn finding(
    rig: &Rig<'_>,
    unknown: &[(&str, &str, &str)],
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
        RULE.at(rig.file, Place::pointer(["bones", bone, member]), message)
            .help(help)
            .evidence(Evidence::of_cases(cases)),
    )
}
