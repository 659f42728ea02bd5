//! A modifier moves targets that exist.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, counted, did_you_mean};
use super::meant::{Meant, meant_groups};
use super::spellings::{Spellings, Starts, categories, help};
use super::{LOST_FILE, LOST_TABS, is_hidden, knows_targets};
use mhlint_diag::{
    Application::Makehuman1, Case, Evidence, Finding, Grouped, Level, Place, RuleInfo, grouped,
};
use mhlint_formats::modifiers::file::Part;
use mhlint_repo::makehuman1::{KnownModifier, View, category};

pub(crate) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(
        Makehuman1,
        "shows a slider that moves nothing, or nothing on one side",
    )],
    docs: include_str!("no_target.md").trim_ascii_end(),
    ..RuleInfo::new(
        "modifiers-no-target",
        Level::Warning,
        "a modifier without targets",
    )
});

const LOST: Case = &[(Makehuman1, Level::Error, LOST_TABS)];
const STOPPED: Case = &[(Makehuman1, Level::Error, LOST_FILE)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    if !view.layers.checks_system() || !knows_targets(view) {
        return;
    }
    let meant = Meant::of(view, cx);
    let bare = bare_groups(view);
    if let Some(finding) = renamed_folder(view).filter(|_| !bare.is_empty()) {
        return out.push(finding);
    }
    let mut starts = BTreeMap::new();
    // The sliders name it otherwise, and there it is told (`modifiers-unknown-in-slider`).
    let renamed: BTreeSet<&str> = meant_groups(view, cx).into_values().collect();
    for (group, all) in bare.iter().filter(|(group, _)| !renamed.contains(*group)) {
        let words = group.split('-').count();
        let starts = starts
            .entry(words)
            .or_insert_with(|| Starts::of(view, words));
        out.extend(group_finding(starts, all, cx));
    }
    let (spellings, present) = (Spellings::of(view), categories(view));
    let others = view
        .modifiers
        .all
        .iter()
        .filter(|one| bare.get(one.modifier.group.as_str()).is_none());
    for one in others.filter(|one| !is_hidden(view, one)) {
        match &one.modifier.variable {
            Some(variable) => out.extend(macro_finding(&present, one, &variable.name)),
            None if one.modifier.tails.unpaired().is_none() => {
                out.extend(finding(view, one, &meant, &spellings, cx));
            }
            None => {}
        }
    }
}

/// The folder of all targets has another name.
fn renamed_folder(view: &View<'_>) -> Option<Finding> {
    let folder = view.targets.renamed_folder()?;
    let targets = counted(view.targets.shipped.len(), "target");
    let message = format!(
        "`{folder}` must be named `targets`: its name is a word of the groups of all {targets} in \
            it"
    );
    let finding = RULE
        .in_layer(view.layers.checked, folder, message)
        .key("folder")
        .case(STOPPED);
    Some(finding.help("rename it to `targets`"))
}

/// Groups of several modifiers of which none has a target: the group, or the folder of its targets,
/// has another name.
fn bare_groups<'v>(view: &'v View<'_>) -> Grouped<&'v str, &'v KnownModifier<'v>> {
    let has_none = |one: &&KnownModifier<'_>| one.parts.iter().all(|part| part.targets.is_empty());
    let mut groups = grouped(
        view.modifiers
            .all
            .iter()
            .map(|one| (one.modifier.group.as_str(), one)),
    );
    groups.retain(|_, all| all.len() > 1 && all.iter().all(has_none));
    groups
}

fn group_finding(starts: &Starts, all: &[&KnownModifier<'_>], cx: &RuleCx<'_>) -> Option<Finding> {
    let first = all.first()?;
    let group = first.modifier.group.as_str();
    let message = format!(
        "no file makes a target for group `{group}`, which has {} modifiers",
        all.len()
    );
    let entry = first.modifier.pointer.split('/').nth(1)?;
    let finding = RULE
        .at(
            first.file,
            Place::Pointer(format!("/{entry}/group")),
            message,
        )
        .key(format!("group {group}"));
    let is_macro = all.iter().any(|one| one.modifier.variable.is_some());
    let evidence = Evidence::of_cases(all.iter().map(|one| one.name.as_str()));
    let near = starts
        .same(group)
        .or_else(|| cx.suggestions.nearest(group, starts.all()));
    let finding = finding.evidence(evidence).help(did_you_mean(
        near,
        "correct the group, or the names of its targets",
    ));
    Some(if is_macro {
        finding.case(STOPPED)
    } else {
        finding
    })
}

/// A finding on a modifier as a whole.
fn at(one: &KnownModifier<'_>, message: String) -> Finding {
    let place = Place::Pointer(one.modifier.pointer.clone());
    RULE.at(one.file, place, message).key(&one.name)
}

fn macro_finding(
    present: &BTreeSet<(&str, &str)>,
    one: &KnownModifier<'_>,
    variable: &str,
) -> Option<Finding> {
    let category = category(variable)?;
    let mut groups = one.parts.iter().map(|part| part.group.as_str());
    if groups.any(|group| present.contains(&(group, category))) {
        return None;
    }
    let message = format!(
        "no target of `{}` depends on {category}",
        one.modifier.group
    );
    let finding = at(one, message).case(STOPPED);
    Some(finding.help("correct `group`, or add the targets"))
}

fn finding(
    view: &View<'_>,
    one: &KnownModifier<'_>,
    meant: &Meant<'_>,
    spellings: &Spellings<'_>,
    cx: &RuleCx<'_>,
) -> Option<Finding> {
    let missing = one.parts.iter().filter(|part| part.targets.is_empty());
    let missing: Vec<(&str, Part)> = missing
        .map(|part| (part.group.as_str(), part.part))
        .collect();
    let (group, side) = *missing.first()?;
    let what = match side {
        _ if missing.len() == one.parts.len() => "",
        Part::Left => " for values below 0",
        Part::Right => " for values above 0",
        Part::Centre => " for its middle",
        Part::Macro | Part::Only => "",
    };
    let message = format!(
        "modifier `{}` has no target{what}: no file makes `{group}`",
        one.name
    );
    let finding = at(one, message)
        .evidence(Evidence::of_cases(missing.iter().map(|(group, _)| *group)))
        .help(help(view, one, group, spellings, cx));
    let Some(slider) = meant.slider_for(one) else {
        return Some(finding);
    };
    let finding = finding.case(LOST);
    Some(match spellings.sliders.get(slider) {
        Some((file, named)) => finding.related(
            file.path.clone(),
            Place::Pointer(named.pointer.clone()),
            "the slider that means it",
        ),
        None => finding,
    })
}
