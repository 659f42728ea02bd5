//! Groups: what sliders ask for and what categories offer.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::is_generated_for;
use super::super::cause::overlay::is_damaged;
use crate::diag::nearest;
use crate::formats::modelling::EFFECTS;
use crate::formats::target_cat::Category;
use crate::repo::makehuman2::{Base, BoundSlider};

/// Category that MakeHuman 2 always replaces with the generated one.
pub(super) const USER_CATEGORY: &str = "User";

/// Groups of a base.
pub(super) struct Groups<'b, 'a> {
    /// Groups that an item shows.
    pub(super) offered: BTreeSet<String>,
    /// Groups that only a category shows which is replaced at load.
    pub(super) replaced: BTreeSet<String>,
    /// Groups that no item shows, with their sliders in order.
    pub(super) unknown: BTreeMap<&'b str, Vec<&'b BoundSlider<'a>>>,
    /// Categories whose `group` is not what the sliders of their items say; those are not in `unknown`.
    pub(super) renamed: Vec<Renamed<'b, 'a>>,
}

/// A category whose `group` is wrong.
pub(super) struct Renamed<'b, 'a> {
    /// Its display name.
    pub(super) name: &'b str,
    /// Its `group` as it is.
    pub(super) group: &'b str,
    /// As the sliders have it.
    pub(super) wanted: String,
    /// The sliders that are hidden by it.
    pub(super) sliders: Vec<&'b BoundSlider<'a>>,
}

/// Groups, if categories and sliders can be read. Sliders of generated files have generated groups.
pub(super) fn of<'b, 'a>(base: &'b Base<'a>) -> Option<Groups<'b, 'a>> {
    if is_damaged(&base.categories) || is_damaged(&base.modelling) {
        return None;
    }
    let (file, categories) = base.categories.winner()?;
    // A misspelt key is a finding of its own, and so is a wrong shape.
    if !file.schema.faults.is_empty() || file.schema.unknown.iter().any(|key| key.nearest.is_some()) {
        return None;
    }
    let mut offered = BTreeSet::new();
    let mut replaced = BTreeSet::new();
    for category in &categories.categories {
        let groups = if category.name == USER_CATEGORY { &mut replaced } else { &mut offered };
        groups.extend(category.items.iter().filter_map(|item| category.group_of(item)));
    }
    let mut unknown: BTreeMap<&str, Vec<_>> = BTreeMap::new();
    for slider in hand_made(base).filter(|slider| slider.slider.group.is_some() || is_ungrouped(slider)) {
        let group = slider.slider.group.as_deref().unwrap_or_default();
        if !offered.contains(group) && !replaced.contains(group) {
            unknown.entry(group).or_default().push(slider);
        }
    }
    let renamed = take_renamed(base, &categories.categories, &offered, &mut unknown);
    Some(Groups { offered, replaced, unknown, renamed })
}

/// Takes the sliders out of `unknown` that would be shown if a category had another `group`: several sliders agree
/// on it, its items have their names, and nothing else uses it.
fn take_renamed<'b, 'a>(
    base: &'b Base<'a>,
    categories: &'b [Category],
    offered: &BTreeSet<String>,
    unknown: &mut BTreeMap<&'b str, Vec<&'b BoundSlider<'a>>>,
) -> Vec<Renamed<'b, 'a>> {
    let first = |group: &str| group.split('|').next().unwrap_or_default().to_owned();
    let used: BTreeSet<String> = base.sliders.iter().filter_map(|s| s.as_meant().group.as_deref()).map(first).collect();
    let mut renamed = Vec::new();
    for category in categories {
        let Some(group) = category.group.as_deref().filter(|group| !used.contains(*group)) else { continue };
        let has = |sub: &str| category.items.iter().any(|item| item.cat.as_deref() == Some(sub));
        let lost = unknown.keys().filter_map(|lost| lost.split_once('|')).filter(|(_, sub)| has(sub));
        let Some((wanted, _)) = lost.into_iter().find(|(wanted, _)| !offered.iter().any(|own| first(own) == *wanted))
        else {
            continue;
        };
        let wanted = wanted.to_owned();
        let groups: Vec<&'b str> = unknown.keys().copied().filter(|lost| first(lost) == wanted).collect();
        let count: usize = groups.iter().filter_map(|group| unknown.get(group)).map(Vec::len).sum();
        // One slider alone is more likely to be wrong itself.
        if count < 2 {
            continue;
        }
        let sliders = groups.iter().filter_map(|group| unknown.remove(group)).flatten().collect();
        renamed.push(Renamed { name: &category.name, group, wanted, sliders });
    }
    renamed
}

/// Whether a slider has no group at all, and nothing worse is to be said of it.
fn is_ungrouped(slider: &BoundSlider<'_>) -> bool {
    !slider.as_meant().has("group") && EFFECTS.iter().any(|key| slider.as_meant().has(key))
}

/// Sliders that are not generated from user targets.
pub(super) fn hand_made<'b, 'a>(base: &'b Base<'a>) -> impl Iterator<Item = &'b BoundSlider<'a>> {
    base.sliders.iter().filter(|slider| !is_generated_for(base, slider.file))
}

impl Groups<'_, '_> {
    /// What an unknown group was probably meant to be.
    pub(super) fn meant(&self, group: &str) -> Option<&str> {
        nearest(group, self.offered.iter().map(String::as_str))
    }

    /// Whether a slider that is not shown belongs to this category.
    pub(super) fn has_unknown_in(&self, category: &str) -> bool {
        self.unknown.keys().any(|group| group.split('|').next() == Some(category))
    }

    /// Whether some item shows a group of this category.
    pub(super) fn knows_category(&self, category: &str) -> bool {
        self.offered.iter().any(|group| group.split('|').next() == Some(category))
    }

    /// Whether an empty item was probably meant for a slider whose group is reported.
    pub(super) fn is_excused(&self, offered: &str) -> bool {
        let category = |group: &str| group.split('|').next().unwrap_or_default().to_owned();
        let mut unknown = self.unknown.keys();
        unknown
            .any(|group| self.meant(group) == Some(offered) || group.is_empty() || category(group) == category(offered))
    }
}
