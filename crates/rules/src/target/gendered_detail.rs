//! A detail does not depend on some values of a macro alone.

use std::collections::BTreeMap;

use super::super::{Check, Rule, RuleCx, enumerated};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_formats::target::name::CATEGORIES;
use mhlint_repo::makehuman1::{NamedTarget, View};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "applies it with a part of its weight, or not at all, at other values of the macro",
    )],
    docs: include_str!("gendered_detail.md").trim_ascii_end(),
    ..RuleInfo::new(
        "target-gendered-detail",
        Level::Warning,
        "a detail that depends on some values of a macro",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || view.targets.is_packed {
        return;
    }
    let details = view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.variable.is_none());
    let mut told: BTreeMap<&str, Vec<Finding>> = BTreeMap::new();
    for part in details.flat_map(|one| &one.parts) {
        let of_group = || findings(view, &part.targets);
        let found = told.entry(&part.group).or_insert_with(of_group);
        out.extend(found.iter().cloned());
    }
}

fn findings(view: &View<'_>, places: &[usize]) -> Vec<Finding> {
    let targets: Vec<&NamedTarget<'_>> = places
        .iter()
        .filter_map(|place| view.targets.at(*place))
        .collect();
    let mut found = Vec::new();
    for (category, words) in CATEGORIES {
        let values: Vec<&str> = words
            .iter()
            .copied()
            .filter(|word| {
                targets
                    .iter()
                    .any(|target| target.name.value(category) == Some(word))
            })
            .collect();
        let Some(first) = targets
            .iter()
            .find(|target| target.name.value(category).is_some())
        else {
            continue;
        };
        if values.len() == words.len() {
            continue;
        }
        let quoted: Vec<String> = values.iter().map(|value| format!("`{value}`")).collect();
        let message = format!(
            "depends on {category}: there is a target for {} alone",
            enumerated(&quoted)
        );
        let finding = RULE.at(first.file, Place::File, message).key(category);
        let others: Vec<&str> = words
            .iter()
            .copied()
            .filter(|word| !values.contains(word))
            .collect();
        found.push(finding.help(format!(
            "rename it, or add targets for {}",
            enumerated(&others)
        )));
    }
    found
}
