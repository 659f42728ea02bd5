//! Every skeleton of a base has a name of its own.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use super::{Rig, rigs};
use mhlint_diag::{Application::Makehuman2, Finding, Level, Place, RuleInfo};
use mhlint_repo::Body;

pub(crate) static RULE: Rule = Check::Body(run).rule(RuleInfo {
    breaks: &[(
        Makehuman2,
        "lists only one of the skeletons; the others cannot be chosen",
    )],
    docs: include_str!("name_clash.md").trim_ascii_end(),
    ..RuleInfo::new(
        "skeleton-name-clash",
        Level::Error,
        "two skeletons of a base have the same name",
    )
});

fn run(body: &Body<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let mut by_name: BTreeMap<&str, Vec<Rig<'_>>> = BTreeMap::new();
    let mut seen = BTreeSet::new();
    for rig in rigs(body) {
        let Some(name) = rig.skeleton.name.as_deref().filter(|name| !name.is_empty()) else {
            continue;
        };
        let same_name = by_name.entry(name).or_default();
        // Layers come strongest first: a file at the same path is the one that this one replaces.
        if seen.insert((name, rig.file.rel.as_str())) {
            same_name.push(rig);
        }
    }
    out.extend(
        by_name
            .iter()
            .filter_map(|(name, rigs)| finding(body, name, rigs)),
    );
}

fn finding(body: &Body<'_>, name: &str, rigs: &[Rig<'_>]) -> Option<Finding> {
    // The skeleton for poses is the one to keep the name, and a finding stands in the data that are
    // checked.
    let is_own = |rig: &&Rig<'_>| body.layers.is_checked(rig.file);
    let own = rigs.iter().filter(is_own);
    let told = own
        .max_by_key(|rig| (!rig.own.is_default, &rig.file.rel))
        .filter(|_| rigs.len() > 1)?;
    let others: Vec<&Rig<'_>> = rigs
        .iter()
        .filter(|rig| rig.file.path != told.file.path)
        .collect();
    let first = others.first()?;
    let more = if others.len() > 1 {
        format!(" and {} more", others.len() - 1)
    } else {
        String::new()
    };
    let message = format!(
        "the name `{name}` is also used by `{}`{more}",
        first.file.shown()
    );
    let mut finding = RULE
        .at(told.file, Place::pointer(["name"]), message)
        .key(name)
        .between(rigs.iter().map(|rig| rig.file.path.as_str()))
        .help("give each skeleton a name of its own");
    for other in others {
        finding = finding.related(
            other.file.path.clone(),
            Place::pointer(["name"]),
            "the same name",
        );
    }
    Some(finding)
}
