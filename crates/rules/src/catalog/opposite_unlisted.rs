//! `targets` of a slider names what its slots do.

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Check, Rule, RuleCx, counted};
use super::{checked, place, sliders};
use mhlint_diag::{Application::Mpfb, Evidence, Finding, Level, RuleInfo, grouped};
use mhlint_formats::target_catalog::{Category, Slot};
use mhlint_repo::mpfb::View;

pub(crate) static RULE: Rule = Check::Mpfb(run).rule(RuleInfo {
    breaks: &[(
        Mpfb,
        "does not mark the slider as changed when only this target is applied",
    )],
    docs: include_str!("opposite_unlisted.md").trim_ascii_end(),
    ..RuleInfo::new(
        "catalog-opposite-unlisted",
        Level::Info,
        "the slots and `targets` of a slider differ",
    )
});

fn run(view: &View<'_>, _: &RuleCx<'_>, out: &mut Vec<Finding>) {
    let Some(catalog) = checked(view) else { return };
    let mut uses: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for (section, category) in sliders(&catalog) {
        let slots = category
            .slots_in_use()
            .map(|slot| (section.name.as_str(), slot.stem.as_str()));
        slots.for_each(|slot| *uses.entry(slot).or_default() += 1);
    }
    let apart = sliders(&catalog).filter_map(|(section, category)| {
        let is_there = |name: &str| catalog.target(&section.name, name).is_some();
        let is_found = |slot: &Slot| catalog.target(&section.name, &slot.stem).is_some();
        let is_shared = |slot: &Slot| {
            uses.get(&(section.name.as_str(), slot.stem.as_str()))
                .is_some_and(|uses| *uses > 1)
        };
        // A slider whose slots are at fault has a finding of its own.
        if !is_sound(category)
            || category.slots_in_use().any(is_shared)
            || !category.slots_in_use().all(is_found)
        {
            return None;
        }
        let first = unlisted(category).find(|name| is_there(name))?;
        Some((section.name.as_str(), (section, category, first)))
    });
    for (_, all) in grouped(apart) {
        let Some((section, category, first)) = all.first() else {
            continue;
        };
        let message = match all.len() {
            1 => format!(
                "`{first}` is in only one of the slots and `targets` of `{}`",
                category.name
            ),
            many => format!(
                "slots and `targets` differ in {} of section `{}`, first in `{}`",
                counted(many, "slider"),
                section.name,
                category.name
            ),
        };
        let finding = RULE
            .at(catalog.file, place(section, Some(category), &[]), message)
            .key(&section.name);
        let finding = finding.evidence(Evidence::of_cases(
            all.iter().map(|(_, category, _)| category.name.clone()),
        ));
        out.push(finding.help("let `targets` list what the slots name"));
    }
}

/// Whether every slot is there and has a target of its own.
fn is_sound(category: &Category) -> bool {
    let stems: BTreeSet<&str> = category
        .slots_in_use()
        .map(|slot| slot.stem.as_str())
        .collect();
    let slots = if category.is_sided { 4 } else { 2 };
    stems.len() == slots && category.slots_in_use().count() == slots
}

/// Targets in a slot and not in the list, and the reverse.
fn unlisted(category: &Category) -> impl Iterator<Item = &str> {
    let slots = || {
        category
            .slots_in_use()
            .filter(|slot| !slot.stem.is_empty())
            .map(|slot| slot.stem.as_str())
    };
    let listed = || category.targets.iter().map(|(_, name)| name.as_str());
    // Without slots the list is not compared: the one target has the name of the slider.
    let has_slots = category.slots.is_some() && !category.targets.is_empty();
    let lacking = slots().filter(move |stem| !listed().any(|name| name == *stem));
    let further = listed().filter(move |name| !slots().any(|stem| stem == *name));
    lacking.chain(further).filter(move |_| has_slots)
}
