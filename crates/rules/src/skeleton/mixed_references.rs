//! A skeleton refers to the base skeleton in one way.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::remapped::{Remapped, remapped};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "gives the weights of these bones twice: to the bone itself, and to the one above it",
    )],
    docs: include_str!("mixed_references.md").trim_ascii_end(),
    counts: "bones",
    ..RuleInfo::new(
        "skeleton-mixed-references",
        Level::Warning,
        "bones whose weights two bones take",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_makehuman1() {
        out.extend(remapped(body).iter().filter_map(finding));
    }
}

fn finding(remapped: &Remapped<'_>) -> Option<Finding> {
    let bones = &remapped.rig.skeleton.bones;
    let mut takers: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (bone, sources) in remapped.sources.own.iter().enumerate() {
        sources
            .iter()
            .for_each(|source| takers.entry(*source).or_default().push(bone));
    }
    // Of those that take what no list names the first one stands for all.
    let mut free_takers: BTreeMap<usize, usize> = BTreeMap::new();
    for free in &remapped.sources.free {
        let first = free.takers.first();
        free_takers.extend(
            first
                .into_iter()
                .flat_map(|first| free.bones.iter().map(move |source| (*source, *first))),
        );
    }
    let is_twice = |(place, own): &(usize, &Vec<usize>)| {
        let bone = bones.get(*place)?;
        let shared = own
            .first()
            .filter(|_| bone.weight_references().0.is_empty())?;
        let other = takers.get(shared)?.iter().find(|taker| *taker != place);
        let taker = other.into_iter().chain(free_takers.get(shared)).min()?;
        Some((bone.name.as_str(), *taker))
    };
    let twice: Vec<(&str, usize)> = remapped
        .sources
        .own
        .iter()
        .enumerate()
        .filter_map(|pair| is_twice(&pair))
        .collect();
    let (first, taker) = twice.first()?;
    let names: Vec<&str> = twice.iter().map(|(name, _)| *name).collect();
    let other = bones.get(*taker).map_or("", |bone| bone.name.as_str());
    let have = if names.len() == 1 { "has" } else { "have" };
    let message = format!(
        "{} {have} no `reference`, and `{other}` takes the same weights",
        bones_in_words(&names)
    );
    let finding = RULE
        .at(remapped.rig.file, Place::pointer(["bones", first]), message)
        .parts(names.iter().copied());
    let finding = finding.evidence(Evidence::of_cases(&names).out_of(bones.len()));
    Some(finding.help(format!("add `\"reference\": [\"{first}\"]`")))
}
