//! A modifier moves targets that exist.

use super::super::{Check, Rule, RuleCx, did_you_mean};
use super::meant::Meant;
use super::{LOST_FILE, LOST_TABS};
use crate::diag::{Application::Makehuman1, Case, Evidence, Finding, Level, Place, RuleInfo};
use crate::formats::modifier_file::Part;
use crate::formats::target_name::category_of;
use crate::repo::makehuman1::{KnownModifier, View, category};

pub(in crate::rules) static RULE: Rule = Check::Makehuman1(run).rule(RuleInfo {
    breaks: &[(Makehuman1, "shows a slider that moves nothing, or nothing on one side")],
    docs: "A modifier of MakeHuman 1 moves the targets of a group: `group-target-min` for negative values and \
        `group-target-max` for positive ones, or `group-target`. The words of a target's path make its group, \
        `targets/head/head-age-incr.target` is in `head-head-age-incr`; capitals count, and a name of a modifier is split at \
        `-` alone. With `macrovar` the modifier moves those targets of its `group` that depend on the variable.\n\n\
        Without targets the slider is there and moves nothing. If its sliders file knows the modifier by another name, the \
        rest of the tab and all tabs behind it are missing. Without any target for its variable a macro stops the whole \
        file.\n\n\
        Correct `group`, `target`, `min` or `max`, or the name of the file.",
    ..RuleInfo::new("modifiers-no-target", Level::Warning, "a modifier without targets")
});

const LOST: Case = &[(Makehuman1, Level::Error, LOST_TABS)];
const STOPPED: Case = &[(Makehuman1, Level::Error, LOST_FILE)];

fn run(view: &View<'_>, cx: &RuleCx<'_>, out: &mut Vec<Finding>) {
    // In an archive nobody looks, and no target is found where the names of folders stop the search.
    let is_unknown = view.targets.is_packed || !view.targets.clashes.is_empty();
    if !view.layers.checks_system() || is_unknown {
        return;
    }
    let meant = Meant::of(view, cx);
    for one in &view.modifiers.all {
        match &one.modifier.variable {
            Some(variable) => out.extend(macro_finding(view, one, &variable.name)),
            None if one.modifier.tails.unpaired().is_none() => out.extend(finding(view, one, &meant, cx)),
            None => {}
        }
    }
}

fn macro_finding(view: &View<'_>, one: &KnownModifier<'_>, variable: &str) -> Option<Finding> {
    let category = category(variable)?;
    let targets = one.parts.iter().flat_map(|part| &part.targets).filter_map(|place| view.targets.at(*place));
    let depends = targets.into_iter().any(|target| target.name.value(category).is_some());
    if depends {
        return None;
    }
    let message = format!("no target of `{}` depends on {category}", one.modifier.group);
    let finding = RULE.at(one.file, Place::Pointer(one.modifier.pointer.clone()), message).key(&one.name).case(STOPPED);
    Some(finding.help("correct `group`, or add the targets"))
}

fn finding(view: &View<'_>, one: &KnownModifier<'_>, meant: &Meant<'_>, cx: &RuleCx<'_>) -> Option<Finding> {
    let missing: Vec<&str> =
        one.parts.iter().filter(|part| part.targets.is_empty()).map(|part| part.group.as_str()).collect();
    let first = *missing.first()?;
    let all = missing.len() == one.parts.len();
    let side = one.parts.iter().find(|part| part.group == first).map(|part| part.part);
    let what = match side {
        Some(Part::Left) if !all => " for values below 0",
        Some(Part::Right) if !all => " for values above 0",
        Some(Part::Centre) if !all => " for its middle",
        _ => "",
    };
    let message = format!("modifier `{}` has no target{what}: no file makes `{first}`", one.name);
    let finding = RULE.at(one.file, Place::Pointer(one.modifier.pointer.clone()), message).key(&one.name);
    let finding = finding.evidence(Evidence::of_cases(missing.iter().copied())).help(help(view, one, first, cx));
    let Some(slider) = meant.slider_for(one) else { return Some(finding) };
    let set = view.modifiers.sets.iter().filter_map(|set| set.sliders);
    let at = set.flat_map(|(file, sliders)| sliders.modifiers().map(move |named| (file, named)));
    let at = at.into_iter().find(|(_, named)| named.name == slider);
    let finding = finding.case(LOST);
    Some(match at {
        Some((file, named)) => {
            finding.related(file.path.clone(), Place::Pointer(named.pointer.clone()), "the slider that means it")
        }
        None => finding,
    })
}

fn help(view: &View<'_>, one: &KnownModifier<'_>, group: &str, cx: &RuleCx<'_>) -> String {
    if let Some(word) = group.split('-').find(|word| category_of(word).is_some()) {
        let category = category_of(word).unwrap_or_default();
        return format!("`{word}` in a name is a value of {category} and in no group: choose another word");
    }
    let split = group.replace(['_', '.'], "-");
    let same = |other: &&str| other.eq_ignore_ascii_case(&split) || other.replace("--", "-") == *group;
    let near = view.targets.groups().find(same).or_else(|| cx.suggestions.nearest(group, view.targets.groups()));
    let of_group = near.and_then(|near| view.targets.of_group(near).first()).and_then(|place| view.targets.at(*place));
    let file = of_group.map(|target| target.file.rel.clone());
    did_you_mean(file.as_deref(), format!("correct `target` of `{}`, or add the target", one.modifier.group))
}
