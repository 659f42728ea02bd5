//! A bone of another skeleton gets weights from the default one.

use std::collections::BTreeSet;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::measured::{Measured, measured};
use super::remapped::{Remapped, remapped};
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Confidence, Evidence, Finding, Level, Place, RuleInfo,
};
use mhlint_eval::measures::Measures;
use mhlint_formats::mhskel::{Bone, Skeleton};
use mhlint_repo::{Body, FileFacts, Rig};

pub(crate) static RULE: Rule = Check::Numeric(run).rule(RuleInfo {
    breaks: &[
        (
            Makehuman2,
            "exports the bone without vertices: it moves nothing",
        ),
        (
            Makehuman1,
            "exports the bone without vertices: the root bone gets what it was to move",
        ),
    ],
    docs: include_str!("unweighted_bone.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-unweighted-bone",
        Level::Warning,
        "a bone gets no weights through its references",
    )
});

fn run(body: &Body<'_>, measures: &Measures, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(default) = body.default_rig().and_then(Rig::skeleton) else {
        return;
    };
    if body.is_makehuman1() {
        return out.extend(remapped(body).iter().filter_map(of_remapped));
    }
    let defaults: BTreeSet<&str> = default
        .bones
        .iter()
        .map(|bone| bone.name.as_str())
        .collect();
    for rig in measured(body, measures)
        .into_iter()
        .filter(receives_anything)
    {
        let bare: BTreeSet<&String> = rig.measure.received.without_weights.iter().collect();
        let parents: BTreeSet<&str> = rig
            .skeleton
            .bones
            .iter()
            .filter_map(|bone| bone.parent.as_deref())
            .collect();
        let is_end = |bone: &Bone| bone.parent.is_some() && !parents.contains(bone.name.as_str());
        let is_lacking = |bone: &&Bone| {
            bare.contains(&bone.name) && names_nothing(bone, &defaults) && is_end(bone)
        };
        let bones: Vec<&str> = rig
            .bones()
            .map(|(bone, _)| bone)
            .filter(is_lacking)
            .map(|bone| bone.name.as_str())
            .collect();
        out.extend(finding(rig.file, rig.skeleton, &bones));
    }
}

/// Bones other than the root that take nothing of the base skeleton. Names that do not exist are
/// reported as such.
fn of_remapped(remapped: &Remapped<'_>) -> Option<Finding> {
    let bones = remapped
        .rig
        .skeleton
        .bones
        .iter()
        .zip(&remapped.sources.own);
    let is_bare = |(bone, sources): &(&Bone, &Vec<usize>)| {
        sources.is_empty() && bone.parent.is_some() && bone.weight_references().0.is_empty()
    };
    let bare: Vec<&str> = bones
        .filter(is_bare)
        .map(|(bone, _)| bone.name.as_str())
        .collect();
    finding(remapped.rig.file, remapped.rig.skeleton, &bare)
}

/// Of a skeleton that nothing of the weights comes to, `skeleton-unclaimed-bones` says so.
fn receives_anything(rig: &Measured<'_>) -> bool {
    rig.measure.received.without_weights.len() < rig.skeleton.bones.len()
        || rig.measure.received.lost_vertices == 0
}

/// A bone that names default bones takes what they have, be it nothing; names that do not exist are
/// reported as such.
fn names_nothing(bone: &Bone, defaults: &BTreeSet<&str>) -> bool {
    let lists = [&bone.reference, &bone.weights_reference];
    lists.iter().all(|list| list.iter().all(Vec::is_empty))
        && !defaults.contains(bone.name.as_str())
}

fn finding(file: &FileFacts, skeleton: &Skeleton, bones: &[&str]) -> Option<Finding> {
    let first = bones.first()?;
    let message = match bones.len() {
        1 => {
            format!(
                "{} gets no weights: it has no references, and no default bone has its name",
                bones_in_words(bones)
            )
        }
        _ => {
            format!(
                "{} get no weights: they have neither references nor names of default bones",
                bones_in_words(bones)
            )
        }
    };
    Some(
        RULE.at(file, Place::key(["bones", first]), message)
            .confidence(Confidence::Medium)
            .help("list bones of the default skeleton in `reference`")
            .evidence(Evidence::of_cases(bones).out_of(skeleton.bones.len())),
    )
}
