//! A macro variable is set in one group.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx};
use mhlint_diag::{Application::Makehuman1, Finding, Level, Place, RuleInfo};
use mhlint_repo::makehuman1::{KnownModifier, View, category};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "logs an error; of two groups for one variable the first keeps it",
    )],
    docs: include_str!("second_group.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-second-group",
        Level::Warning,
        "two groups that set one macro variable",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() {
        return;
    }
    let mut first: BTreeMap<&str, &KnownModifier<'_>> = BTreeMap::new();
    let known = view.modifiers.all.iter().map(|one| one.modifier);
    let known = known.filter_map(|own| Some((&*own.variable.as_ref()?.name, &*own.group)));
    let known: BTreeSet<(&str, &str)> = known.collect();
    for one in &view.modifiers.all {
        let Some((variable, category)) = one
            .modifier
            .variable
            .as_ref()
            .and_then(|own| Some((own, category(&own.name)?)))
        else {
            continue;
        };
        let earlier = first.entry(category).or_insert(one);
        if earlier.modifier.group == one.modifier.group {
            continue;
        }
        let message = format!(
            "{category} is set by group `{}` already",
            earlier.modifier.group
        );
        let finding = RULE
            .at(one.file, Place::Pointer(variable.pointer.clone()), message)
            .key(&one.name);
        let finding = finding.related(
            earlier.file.path.clone(),
            Place::Pointer(earlier.modifier.pointer.clone()),
            "the first modifier for it",
        );
        let (variable, group) = (variable.name.as_str(), earlier.modifier.group.as_str());
        let is_there = known.contains(&(variable, group));
        out.push(finding.help(help(is_there, variable, group)));
    }
}

/// A group has one modifier for a variable.
fn help(is_there: bool, variable: &str, group: &str) -> String {
    if is_there {
        format!(
            "remove the modifier with its slider and description: group `{group}` has one for \
                `{variable}`"
        )
    } else {
        format!(
            "move the modifier to group `{group}`, and correct its name in sliders and descriptions"
        )
    }
}
