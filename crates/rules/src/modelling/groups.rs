//! Groups: what sliders ask for and what categories offer.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::is_generated_for;
use super::super::cause::overlay::is_damaged;
use mhlint_diag::{Place, Suggestions, grouped};
use mhlint_formats::modelling::EFFECTS;
use mhlint_formats::target_cat::{Category, Item};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, BoundSlider, View};

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
    /// Categories whose `group` is not what the sliders of their items say; those are not in
    /// `unknown`.
    pub(super) renamed: Vec<Renamed<'b, 'a>>,
    /// What groups of `unknown` were probably meant to be.
    meant: BTreeMap<&'b str, String>,
    /// These groups.
    near: BTreeSet<String>,
    /// Categories of the unknown groups.
    lost_categories: BTreeSet<&'b str>,
    /// Categories of `offered`.
    categories: BTreeSet<String>,
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
pub(super) fn of<'b, 'a>(base: &'b Base<'a>, suggestions: &Suggestions) -> Option<Groups<'b, 'a>> {
    if is_damaged(&base.categories) || is_damaged(&base.modelling) {
        return None;
    }
    let (file, categories) = base.categories.winner()?;
    // A misspelt key is a finding of its own, and so is a wrong shape.
    if !file.schema.faults.is_empty() || file.schema.unknown.iter().any(|key| key.nearest.is_some())
    {
        return None;
    }
    let mut offered = BTreeSet::new();
    let mut replaced = BTreeSet::new();
    for category in &categories.categories {
        let groups = if category.name == USER_CATEGORY {
            &mut replaced
        } else {
            &mut offered
        };
        groups.extend(
            category
                .items
                .iter()
                .filter_map(|item| category.group_of(item)),
        );
    }
    let sliders =
        hand_made(base).filter(|slider| slider.slider.group.is_some() || is_ungrouped(slider));
    let by_group =
        sliders.map(|slider| (slider.slider.group.as_deref().unwrap_or_default(), slider));
    let by_group =
        by_group.filter(|(group, _)| !offered.contains(*group) && !replaced.contains(*group));
    let mut unknown: BTreeMap<_, _> = grouped(by_group).into_iter().collect();
    let of_offered: BTreeSet<String> = offered
        .iter()
        .map(|group| category_of(group).to_owned())
        .collect();
    let renamed = take_renamed(base, &categories.categories, &of_offered, &mut unknown);
    let near = |group| {
        suggestions
            .nearest(group, offered.iter().map(String::as_str))
            .map(str::to_owned)
    };
    let meant: BTreeMap<&str, String> = unknown
        .keys()
        .filter_map(|group| Some((*group, near(group)?)))
        .collect();
    Some(Groups {
        near: meant.values().cloned().collect(),
        lost_categories: unknown.keys().map(|group| category_of(group)).collect(),
        offered,
        replaced,
        unknown,
        renamed,
        meant,
        categories: of_offered,
    })
}

/// The category of a group.
fn category_of(group: &str) -> &str {
    group.split('|').next().unwrap_or_default()
}

/// Takes the sliders out of `unknown` that would be shown if a category had another `group`:
/// several sliders agree on it, its items have their names, and nothing else uses it.
fn take_renamed<'b, 'a>(
    base: &'b Base<'a>,
    categories: &'b [Category],
    offered: &BTreeSet<String>,
    unknown: &mut BTreeMap<&'b str, Vec<&'b BoundSlider<'a>>>,
) -> Vec<Renamed<'b, 'a>> {
    let meant = base
        .sliders
        .iter()
        .filter_map(|slider| slider.as_meant().group.as_deref());
    let used: BTreeSet<&str> = meant.map(category_of).collect();
    // Groups of categories that nobody offers; and by the second half of a group the first such
    // category.
    let mut lost: BTreeMap<&'b str, Vec<&'b str>> = BTreeMap::new();
    let mut by_name: BTreeMap<&'b str, &'b str> = BTreeMap::new();
    for group in unknown
        .keys()
        .filter(|group| !offered.contains(category_of(group)))
    {
        lost.entry(category_of(group)).or_default().push(group);
        if let Some((category, name)) = group.split_once('|') {
            by_name.entry(name).or_insert(category);
        }
    }
    let mut renamed = Vec::new();
    for category in categories {
        let Some(group) = category
            .group
            .as_deref()
            .filter(|group| !used.contains(*group))
        else {
            continue;
        };
        let Some(wanted) = category
            .items
            .iter()
            .filter_map(|item| by_name.get(item.cat.as_deref()?))
            .min()
        else {
            continue;
        };
        let wanted = *wanted;
        let groups = lost.get(wanted).map(Vec::as_slice).unwrap_or_default();
        let count: usize = groups
            .iter()
            .filter_map(|group| unknown.get(group))
            .map(Vec::len)
            .sum();
        // One slider alone is more likely to be wrong itself.
        if count < 2 {
            continue;
        }
        let groups = lost.remove(wanted).unwrap_or_default();
        let sliders = groups
            .iter()
            .filter_map(|group| unknown.remove(group))
            .flatten()
            .collect();
        renamed.push(Renamed {
            name: &category.name,
            group,
            wanted: wanted.to_owned(),
            sliders,
        });
    }
    renamed
}

/// Whether a slider has no group at all, and nothing worse is to be said of it.
fn is_ungrouped(slider: &BoundSlider<'_>) -> bool {
    !slider.as_meant().has("group") && EFFECTS.iter().any(|key| slider.as_meant().has(key))
}

/// Sliders that are not generated from user targets.
pub(super) fn hand_made<'b, 'a>(base: &'b Base<'a>) -> impl Iterator<Item = &'b BoundSlider<'a>> {
    base.sliders
        .iter()
        .filter(|slider| !is_generated_for(base, slider.file))
}

impl Groups<'_, '_> {
    /// What an unknown group was probably meant to be.
    pub(super) fn meant(&self, group: &str) -> Option<&str> {
        self.meant.get(group).map(String::as_str)
    }

    /// Whether a slider that is not shown belongs to this category.
    pub(super) fn has_unknown_in(&self, category: &str) -> bool {
        self.lost_categories.contains(category)
    }

    /// Whether some item shows a group of this category.
    pub(super) fn knows_category(&self, category: &str) -> bool {
        self.categories.contains(category)
    }

    /// Whether an empty item was probably meant for a slider whose group is reported.
    pub(super) fn is_excused(&self, offered: &str) -> bool {
        self.unknown.contains_key("")
            || self.has_unknown_in(category_of(offered))
            || self.near.contains(offered)
    }
}

/// The slider, or the categories if only they are the author's.
pub(super) fn whose<'a>(
    view: &View<'_>,
    base: &Base<'a>,
    slider: &BoundSlider<'a>,
) -> Option<(&'a FileFacts, Place)> {
    if view.layers.is_checked(slider.file) {
        let key = slider.slider.key.as_str();
        let place = if slider.slider.has("group") {
            Place::pointer([key, "group"])
        } else {
            Place::key([key])
        };
        return Some((slider.file, place));
    }
    base.categories
        .winner()
        .map(|(file, _)| (file, Place::File))
}

/// The item that shows the group, if it is the item that has spaces at an end.
pub(super) fn item_with_blanks<'a>(
    view: &View<'_>,
    base: &Base<'a>,
    group: &str,
) -> Option<(&'a FileFacts, Place)> {
    let (file, model) = base
        .categories
        .winner()
        .filter(|(file, _)| view.layers.is_checked(file))?;
    if group.split('|').all(|part| part.trim() == part) {
        return None;
    }
    let is_it =
        |item: &&Item, category: &Category| category.group_of(item).as_deref() == Some(group);
    let find = |category: &'a Category| {
        Some((
            category,
            category
                .items
                .iter()
                .position(|item| is_it(&item, category))?,
        ))
    };
    let (category, at) = model.categories.iter().find_map(find)?;
    Some((
        file,
        Place::pointer([&category.name, "items", &at.to_string(), "cat"]),
    ))
}
