//! Groups of generated sliders: as long as nothing is newer than the two files, MakeHuman 2 takes
//! them as they are.

use std::collections::BTreeSet;

use super::super::cause::is_generated_for;
use super::super::{Rule, such};
use super::marks::ANEW;
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_formats::target_cat::Category;
use mhlint_repo::makehuman2::{Base, BoundSlider};

/// Generated sliders that no item shows.
pub(super) fn hidden(rule: &Rule, base: &Base<'_>) -> Option<Finding> {
    let (_, own) = base
        .user_categories
        .accepted()
        .filter(|(file, _)| file.schema.faults.is_empty())?;
    let others = base
        .categories
        .winner()
        .map(|(_, model)| model.categories.as_slice())
        .unwrap_or_default();
    let items = |category: &Category| {
        category
            .items
            .iter()
            .filter_map(|item| category.group_of(item))
            .collect::<Vec<_>>()
    };
    let offered: BTreeSet<String> = own
        .categories
        .iter()
        .chain(others)
        .flat_map(items)
        .collect();
    let is_hidden = |bound: &&BoundSlider<'_>| {
        let group = bound.slider.group.as_deref();
        is_generated_for(base, bound.file) && group.is_some_and(|group| !offered.contains(group))
    };
    let hidden: Vec<&BoundSlider<'_>> = base.sliders.iter().filter(is_hidden).collect();
    let first = hidden.first().filter(|_| {
        own.categories
            .iter()
            .any(|category| !category.items.is_empty())
    })?;
    let (key, group) = (
        first.slider.key.as_str(),
        first.slider.group.as_deref().unwrap_or_default(),
    );
    let more = such(hidden.len(), "sliders");
    let message = format!(
        "`{key}` is never shown: no item of the generated target_cat.json has the group \
            `{group}`{more}"
    );
    let finding = rule
        .at(first.file, Place::pointer([key, "group"]), message)
        .key("generated")
        .help(ANEW);
    Some(finding.evidence(Evidence::of_cases(
        hidden.iter().map(|bound| &bound.slider.key),
    )))
}
