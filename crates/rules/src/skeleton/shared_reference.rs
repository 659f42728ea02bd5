//! A bone of the base skeleton gives its weights to one bone of another.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, bones_in_words};
use super::remapped::{Remapped, remapped};
use mhlint_diag::{Application::Makehuman1, Evidence, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "gives each of the bones a half of the weights: both pull at the same vertices",
    )],
    docs: include_str!("shared_reference.md").trim_ascii_end(),
    counts: "bones of the base skeleton",
    ..RuleInfo::new(
        "skeleton-shared-reference",
        Level::Warning,
        "two bones refer to the same bone of the base skeleton",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if body.is_makehuman1() {
        out.extend(remapped(body).iter().filter_map(finding));
    }
}

fn finding(remapped: &Remapped<'_>) -> Option<Finding> {
    let bones = &remapped.rig.skeleton.bones;
    let base: BTreeSet<&str> = remapped.base.iter().copied().collect();
    let mut lists: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (place, bone) in bones.iter().enumerate() {
        let (mut references, _) = bone.weight_references();
        // A name that is listed twice counts once.
        references.sort_unstable();
        references.dedup();
        for name in references.into_iter().filter(|name| base.contains(name)) {
            lists.entry(name).or_default().push(place);
        }
    }
    lists.retain(|_, takers| takers.len() > 1);
    let (first, takers) = lists.first_key_value()?;
    let names: Vec<&str> = takers
        .iter()
        .filter_map(|place| Some(bones.get(*place)?.name.as_str()))
        .collect();
    let last = names.last()?;
    let shared: Vec<&str> = lists.keys().copied().collect();
    let more = if shared.len() > 1 {
        format!(" ({} such bones)", shared.len())
    } else {
        String::new()
    };
    let both = if names.len() == 2 { " both" } else { "" };
    let message = format!("{}{both} refer to `{first}`{more}", bones_in_words(&names));
    let finding = RULE
        .at(remapped.rig.file, Place::pointer(["bones", last]), message)
        .parts(shared.iter().copied());
    let finding = finding.evidence(Evidence::of_cases(&shared).out_of(remapped.base.len()));
    Some(finding.help("leave it to one of them, and name another bone in the other"))
}
