//! JSON files of another base, copied over those of this one: one fault, whatever follows from it.

use std::collections::BTreeSet;

use super::super::Rule;
use super::groups::{self, Groups};
use mhlint_diag::{Evidence, Finding, Place};
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

/// No target at all is there of those that the sliders name, but others are.
pub(super) fn sliders(rule: &Rule, view: &View<'_>, base: &Base<'_>) -> Option<Finding> {
    let (file, _) = base
        .modelling
        .winner()
        .filter(|(file, _)| view.layers.is_checked(file))?;
    let folder = base.targets?;
    let names: BTreeSet<&str> = base
        .sliders
        .iter()
        .flat_map(|bound| [&bound.slider.incr, &bound.slider.decr])
        .flatten()
        .map(String::as_str)
        .collect();
    let folder = folder.layer.display(&folder.rel());
    let message = format!(
        "none of the {} targets that the sliders use is in `{folder}`",
        names.len()
    );
    let finding = rule
        .at(file, Place::File, message)
        .key("foreign")
        .evidence(Evidence::of_cases(names));
    Some(finding.help(format!(
        "restore the modelling.json of `{}`; this one seems to belong to another base",
        base.name
    )))
}

/// Groups of which none is offered, from this many on, have one fault between them.
const FOREIGN: usize = 3;

/// No slider at all is shown although there are categories.
pub(super) fn categories(
    rule: &Rule,
    view: &View<'_>,
    base: &Base<'_>,
    groups: &Groups<'_, '_>,
) -> Option<Finding> {
    let mut shown = groups::hand_made(base).filter_map(|bound| bound.as_meant().group.as_deref());
    let is_offered = |group: &str| groups.offered.contains(group);
    if groups.unknown.len() < FOREIGN || groups.offered.is_empty() || shown.any(is_offered) {
        return None;
    }
    let lost: Vec<&BoundSlider<'_>> = groups.unknown.values().flatten().copied().collect();
    let first = lost.first()?;
    let keys = Evidence::of_cases(lost.iter().map(|slider| &slider.slider.key));
    let message = format!(
        "{} sliders are never shown: target_cat.json has none of their groups",
        lost.len()
    );
    let own = base
        .categories
        .winner()
        .filter(|(file, _)| view.layers.is_checked(file));
    let (file, place) = own.map_or_else(
        || (first.file, Place::key([&first.slider.key])),
        |(file, _)| (file, Place::File),
    );
    let help = format!(
        "restore the target_cat.json of `{}`; this one seems to belong to another base",
        base.name
    );
    Some(
        rule.at(file, place, message)
            .key("foreign")
            .help(help)
            .evidence(keys),
    )
}
