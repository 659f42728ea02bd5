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
    for (bone, sources) in remapped.sources.iter().enumerate() {
        sources
            .iter()
            .for_each(|source| takers.entry(*source).or_default().push(bone));
    }
    let is_twice = |(place, own): &(usize, &Vec<usize>)| {
        let bone = bones.get(*place)?;
        let shared = own
            .first()
            .filter(|_| bone.weight_references().0.is_empty())?;
        takers
            .get(shared)?
            .iter()
            .find(|taker| *taker != place)
            .map(|taker| (bone.name.as_str(), *taker))
    };
    let twice: Vec<(&str, usize)> = remapped
        .sources
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
