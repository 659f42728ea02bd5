//! The bone weights of an asset are for bones of the skeleton.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::{blender, lone_archives, texts};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2, Mpfb},
    Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_repo::{Body, FileFacts, ReferenceKind};

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "crashes with `KeyError` in every pose; the glTF export crashes up to \
        2026-08-05 for a model with a skeleton, newer ones leave out the weights",
        ),
        (
            Makehuman1,
            "drops \
            the weights of these bones: vertices that have no others go to the root bone",
        ),
        (
            Mpfb,
            "silently \
                drops the weights of the bone: the asset keeps those that it takes from the body",
        ),
    ],
    levels: &[(Makehuman1, Level::Warning), (Mpfb, Level::Warning)],
    docs: include_str!("custom_weights.md").trim_ascii_end(),
    ..RuleInfo::new(
        "proxy-custom-weights",
        Level::Error,
        "bone weights of an asset name an \
        unknown bone",
    )
});

fn run(body: &Body<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_mpfb() {
        return out.extend(blender::weights::findings(&RULE, body, cx));
    }
    let Some(rig) = body.default_rig() else {
        return;
    };
    let Some(skeleton) = rig.skeleton().filter(|skeleton| !skeleton.bones.is_empty()) else {
        return;
    };
    // A bone that is missing as a parent is reported as such (`skeleton-unknown-parent`).
    let parents = skeleton
        .bones
        .iter()
        .filter_map(|bone| bone.parent.as_deref());
    let known: BTreeSet<&str> = skeleton
        .bones
        .iter()
        .map(|bone| &*bone.name)
        .chain(parents)
        .collect();
    // Of an asset of another base mesh that is the finding.
    let worn = texts(body)
        .filter(|text| !text.is_foreign(body))
        .map(|text| text.worn)
        .chain(lone_archives(body).map(|archive| archive.worn));
    let files = worn.filter_map(|worn| worn.reference(ReferenceKind::AssetWeights)?.meant());
    // Several assets may name one file.
    let files: BTreeMap<&str, &FileFacts> = files.map(|file| (file.path.as_str(), file)).collect();
    for file in files.into_values() {
        let Some(weights) = file.weights().filter(|weights| weights.has_weights) else {
            continue;
        };
        let is_known = |name: &str| known.contains(name);
        let unknown: Vec<&str> = weights
            .bones
            .iter()
            .filter(|bone| bone.listed > 0 && !is_known(&bone.name))
            .map(|bone| &*bone.name)
            .collect();
        let Some(first) = unknown.first() else {
            continue;
        };
        let message = match unknown.len() {
            1 => format!("bone `{first}` does not exist in the skeleton for poses"),
            count => {
                format!("{count} bones do not exist in the skeleton for poses, first `{first}`")
            }
        };
        let near = cx
            .suggestions
            .nearest(first, skeleton.bones.iter().map(|bone| &*bone.name));
        let skeleton = if body.is_makehuman1() {
            "`rigs/default.mhskel`"
        } else {
            "the skeleton that `pose-skeleton` names"
        };
        let help = did_you_mean(near, format!("export the weights for {skeleton}"));
        let finding = RULE.at(file, Place::key(["weights", first]), message);
        out.push(
            finding
                .help(help)
                .against(&rig.file.path)
                .evidence(Evidence::of_cases(unknown.iter().copied())),
        );
    }
}
