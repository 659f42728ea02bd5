//! Rules on the sliders of MPFB: `target.json`, the catalogue, and the targets of users.

mod breaks_start;
mod duplicate_target;
mod empty_section;
mod leftovers;
mod missing_opposites;
mod missing_target;
mod neighbours;
mod no_slider;
mod opposite_unlisted;
mod opposites_sides;
mod side_prefix;
mod twin_pictures;
mod unlisted_target;
mod unreachable_user_target;
mod unused_key;

use super::Rule;
use mhlint_diag::{Place, pointer};
use mhlint_formats::target_catalog::{Category, Section};
use mhlint_repo::mpfb::{Catalog, View, pair};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &breaks_start::RULE,
    &duplicate_target::RULE,
    &empty_section::RULE,
    &missing_opposites::RULE,
    &missing_target::RULE,
    &no_slider::RULE,
    &opposite_unlisted::RULE,
    &opposites_sides::RULE,
    &side_prefix::RULE,
    &unlisted_target::RULE,
    &unreachable_user_target::RULE,
    &unused_key::RULE,
];

/// The catalogue, where it is checked.
fn checked<'a>(view: &View<'a>) -> Option<Catalog<'a>> {
    view.catalog
        .filter(|catalog| view.layers.is_checked(catalog.file))
}

/// All sliders of the checked catalogue.
fn sliders<'c>(
    catalog: &Catalog<'c>,
) -> impl Iterator<Item = (&'c Section, &'c Category)> + use<'c> {
    let sections = catalog.sliders.sections.iter();
    sections.flat_map(|section| {
        section
            .categories
            .iter()
            .map(move |category| (section, category))
    })
}

/// Where something of a section or of one of its sliders stands.
fn place(section: &Section, category: Option<&Category>, member: &[&str]) -> Place {
    let index = category.map(|category| category.index.to_string());
    let above = [
        Some(section.name.as_str()),
        index.as_ref().map(|_| "categories"),
        index.as_deref(),
    ];
    Place::Pointer(pointer(
        &above
            .into_iter()
            .flatten()
            .chain(member.iter().copied())
            .collect::<Vec<_>>(),
    ))
}

/// What one slider is known by in a finding.
fn key(section: &Section, category: &Category) -> String {
    format!("{} {}", section.name, category.name)
}

/// The two ends of a slider without `opposites`, where the disk has these and no target of its
/// name.
fn forgotten_ends(
    catalog: &Catalog<'_>,
    section: &Section,
    category: &Category,
) -> Option<[String; 2]> {
    let (stem, negative, positive) = pair(&category.name).filter(|_| category.slots.is_none())?;
    let side = category.sides().first()?;
    let is_there = |name: &str| {
        catalog
            .target(&section.name, &format!("{side}{name}"))
            .is_some()
    };
    let ends = [format!("{stem}-{negative}"), format!("{stem}-{positive}")];
    (!is_there(&category.name) && ends.iter().all(|end| is_there(end))).then_some(ends)
}
