//! Weights of assets for bones that a rig of MPFB does not have
//! (`docs/loaders/mpfb/clothes.md#files-beside-an-asset`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::cause::groups::{self, Groups};
use super::super::super::{Rule, RuleCx, did_you_mean};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_eval::mpfb::groups::Takers;
use mhlint_formats::mhw::{BoneWeights, Weights};
use mhlint_repo::{Body, BodyWeights, FileFacts, WeightsUse};
use mhlint_source::parent;

/// Weights for bones that no rig has, or that no rig has all of. Nothing where a rig cannot be
/// read.
pub(in crate::proxy) fn findings(rule: &Rule, body: &Body<'_>, cx: &RuleCx<'_>) -> Vec<Finding> {
    let rigs = body
        .rigs
        .iter()
        .filter_map(|rig| Some((rig.file, groups::of(rig.file)?)));
    let rigs: Vec<(&FileFacts, Groups<'_>)> = rigs.collect();
    if rigs.is_empty() || rigs.len() < body.rigs.len() {
        return Vec::new();
    }
    let any = Takers::any_of(rigs.iter().map(|(_, rig)| rig.takers()));
    let distinct = distinct(&rigs);
    let mut room = MOST_COMPARED;
    let finding = |own: &BodyWeights<'_>| {
        let weights = own.file.weights().filter(|weights| weights.has_weights)?;
        let subrig = match subrig(body, own.file) {
            Some(file) => Some(groups::of(file)?),
            None => None,
        };
        let bones: Vec<&BoneWeights> = weights
            .bones
            .iter()
            .filter(|bone| bone.listed > 0)
            .collect();
        let left_by = |takes: &dyn Fn(&str) -> bool| -> Vec<&str> {
            bones
                .iter()
                .map(|bone| bone.name.as_str())
                .filter(|name| !takes(name))
                .collect()
        };
        let is_of_subrig = |name: &str| subrig.as_ref().is_some_and(|rig| rig.take(name));
        let unknown = left_by(&|name| is_of_subrig(name) || groups::take(&any, name));
        if let Some(first) = unknown.first() {
            let near = cx
                .suggestions
                .nearest(first, rigs.iter().flat_map(|(_, rig)| rig.names()));
            let help = did_you_mean(near, "export the weights for a rig of MPFB");
            return Some(told(rule, own.file, &unknown, weights, "any rig").help(help));
        }
        if distinct.len() > FEW {
            room = room.checked_sub(distinct.len() * bones.len())?;
        }
        let left = distinct
            .iter()
            .map(|(file, rig)| (*file, left_by(&|name| is_of_subrig(name) || rig.take(name))));
        let (file, left) = left.min_by_key(|(_, left)| left.len())?;
        if left.is_empty() || serves_several_rigs(&bones) {
            return None;
        }
        let rig = format!(
            "rig `{}`, which has the others",
            file.stem().trim_start_matches("rig.")
        );
        let finding = told(rule, own.file, &left, weights, &rig).against(&file.path);
        Some(finding.help("export the weights with one rig on the figure"))
    };
    let own = body
        .weights
        .iter()
        .filter(|own| own.name.is_none() && own.used != WeightsUse::Unread);
    own.filter_map(finding).collect()
}

/// The first of the rigs that take the same groups.
fn distinct<'r, 'v>(
    rigs: &'r [(&'v FileFacts, Groups<'v>)],
) -> Vec<&'r (&'v FileFacts, Groups<'v>)> {
    let mut seen = BTreeSet::new();
    let is_new = |(_, rig): &&'r (&'v FileFacts, Groups<'v>)| seen.insert(rig.takers());
    rigs.iter().filter(is_new).collect()
}

fn told(rule: &Rule, file: &FileFacts, lost: &[&str], weights: &Weights, which: &str) -> Finding {
    let first = lost.first().copied().unwrap_or_default();
    let message = match lost.len() {
        1 => format!("bone `{first}` does not exist in {which}"),
        count => format!(
            "{count} of {} bones do not exist in {which}, first `{first}`",
            weights.bones.len()
        ),
    };
    let finding = rule.at(file, Place::key(["weights", first]), message);
    finding.evidence(Evidence::of_cases(lost.iter().copied()))
}

/// The sub-rig beside the asset, which has bones of its own.
fn subrig<'v>(body: &Body<'v>, weights: &FileFacts) -> Option<&'v FileFacts> {
    let name = weights.file_name().split('.').next().unwrap_or_default();
    body.layers
        .checked
        .file(&format!("{}/{name}.mpfbskel", parent(&weights.rel)))
}

/// Whether most vertices have weights for more than one rig: those of one come to 1.
fn serves_several_rigs(bones: &[&BoneWeights]) -> bool {
    let mut sums: BTreeMap<i64, f32> = BTreeMap::new();
    for pair in bones.iter().flat_map(|bone| &bone.pairs) {
        *sums.entry(pair.vertex).or_default() += pair.weight;
    }
    let several = sums.values().filter(|sum| **sum > MOST_OF_ONE_RIG).count();
    several * 2 > sums.len()
}

/// Different rigs that all weights are compared with. MPFB has about a dozen.
const FEW: usize = 64;
/// Bones that are looked up in more rigs than that, for all weights: rigs times weights have no
/// end. Of further weights only bones that no rig has are reported.
const MOST_COMPARED: usize = 1 << 22;
/// Weights of one rig come to 1, but for what is rounded.
const MOST_OF_ONE_RIG: f32 = 1.1;
