//! Groups: what sliders ask for and what categories offer.

use std::collections::{BTreeMap, BTreeSet};

use super::is_damaged;
use crate::diag::nearest;
use crate::repo::{Base, BoundSlider};

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
}

/// Groups, if categories and sliders can be read. Sliders of generated files have generated groups.
pub(super) fn of<'b, 'a>(base: &'b Base<'a>) -> Option<Groups<'b, 'a>> {
    if is_damaged(&base.categories) || is_damaged(&base.modelling) {
        return None;
    }
    let (file, categories) = base.categories.winner()?;
    if !file.schema.faults.is_empty() {
        return None;
    }
    let mut offered = BTreeSet::new();
    let mut replaced = BTreeSet::new();
    for category in &categories.categories {
        let groups = if category.name == USER_CATEGORY { &mut replaced } else { &mut offered };
        groups.extend(category.items.iter().filter_map(|item| category.group_of(item)));
    }
    let mut unknown: BTreeMap<&str, Vec<_>> = BTreeMap::new();
    for slider in hand_made(base).filter(|slider| slider.slider.group.is_some() || !slider.as_meant().has("group")) {
        let group = slider.slider.group.as_deref().unwrap_or_default();
        if !offered.contains(group) && !replaced.contains(group) {
            unknown.entry(group).or_default().push(slider);
        }
    }
    Some(Groups { offered, replaced, unknown })
}

/// Sliders that are not generated from user targets.
pub(super) fn hand_made<'b, 'a>(base: &'b Base<'a>) -> impl Iterator<Item = &'b BoundSlider<'a>> {
    let generated = base.user_modelling.file();
    base.sliders.iter().filter(move |slider| !generated.is_some_and(|file| std::ptr::eq(file, slider.file)))
}

impl Groups<'_, '_> {
    /// What an unknown group was probably meant to be.
    pub(super) fn meant(&self, group: &str) -> Option<&str> {
        nearest(group, self.offered.iter().map(String::as_str))
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
