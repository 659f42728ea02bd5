//! Rules on the sliders of MPFB: `target.json`, the catalogue, and the targets of users.

pub(super) mod breaks_start;
pub(super) mod duplicate_target;
pub(super) mod empty_section;
pub(super) mod missing_opposites;
pub(super) mod missing_target;
mod neighbours;
pub(super) mod no_slider;
pub(super) mod opposite_unlisted;
pub(super) mod opposites_sides;
pub(super) mod side_prefix;
pub(super) mod unlisted_target;
pub(super) mod unreachable_user_target;
pub(super) mod unused_key;

use crate::diag::{Place, pointer};
use crate::formats::target_catalog::{Category, Section};
use crate::repo::mpfb::{Catalog, View, pair};

/// The catalogue, where it is checked.
fn checked<'a>(view: &View<'a>) -> Option<Catalog<'a>> {
    view.catalog.filter(|catalog| view.layers.is_checked(catalog.file))
}

/// All sliders of the checked catalogue.
fn sliders<'c>(catalog: &Catalog<'c>) -> impl Iterator<Item = (&'c Section, &'c Category)> + use<'c> {
    let sections = catalog.sliders.sections.iter();
    sections.flat_map(|section| section.categories.iter().map(move |category| (section, category)))
}

/// Where something of a section or of one of its sliders stands.
fn place(section: &Section, category: Option<&Category>, member: &[&str]) -> Place {
    let index = category.map(|category| category.index.to_string());
    let above = [Some(section.name.as_str()), index.as_ref().map(|_| "categories"), index.as_deref()];
    Place::Pointer(pointer(&above.into_iter().flatten().chain(member.iter().copied()).collect::<Vec<_>>()))
}

/// What one slider is known by in a finding.
fn key(section: &Section, category: &Category) -> String {
    format!("{} {}", section.name, category.name)
}

/// The two ends of a slider without `opposites`, where the disk has these and no target of its name.
fn forgotten_ends(catalog: &Catalog<'_>, section: &Section, category: &Category) -> Option<[String; 2]> {
    let (stem, negative, positive) = pair(&category.name).filter(|_| category.slots.is_none())?;
    let side = category.sides().first()?;
    let is_there = |name: &str| catalog.target(&section.name, &format!("{side}{name}")).is_some();
    let ends = [format!("{stem}-{negative}"), format!("{stem}-{positive}")];
    (!is_there(&category.name) && ends.iter().all(|end| is_there(end))).then_some(ends)
}
