//! What the sliders of MPFB ask for (`docs/loaders/mpfb/sliders.md#what-a-slider-does`).

use super::view::{Catalog, OWN};
use crate::{Reference, ReferenceKind, Resolution};
use mhlint_diag::Place;
use mhlint_formats::target_catalog::{Category, Section};
use mhlint_source::normalized;

/// All targets that the catalogue names, in its order.
pub(super) fn collect<'a>(catalog: &Catalog<'a>) -> Vec<Reference<'a>> {
    let mut references = Vec::new();
    for section in &catalog.sliders.sections {
        for category in &section.categories {
            if category.slots.is_some() {
                references.extend(slots(catalog, section, category));
            } else if !category.has_full_path {
                references.extend(names(catalog, section, category));
            }
        }
    }
    references
}

/// Both ends of a slider: exactly one path each, always packed.
fn slots<'a>(
    catalog: &Catalog<'a>,
    section: &'a Section,
    category: &'a Category,
) -> impl Iterator<Item = Reference<'a>> {
    category.slots_in_use().map(|slot| {
        let place = place(section, category, &["opposites", slot.key]);
        let path = format!("{}/{}.target.gz", catalog.folder(&section.name), slot.stem);
        reference(
            catalog,
            ReferenceKind::Slot,
            category,
            place,
            &slot.stem,
            &path,
        )
    })
}

/// The only end of a slider, packed or plain; one for each side.
fn names<'a>(
    catalog: &Catalog<'a>,
    section: &'a Section,
    category: &'a Category,
) -> impl Iterator<Item = Reference<'a>> {
    category.sides().iter().map(|side| {
        let place = place(section, category, &["name"]);
        let stem = format!("{}/{side}{}", catalog.folder(&section.name), category.name);
        let asked = |suffix| {
            let path = format!("{stem}{suffix}");
            reference(
                catalog,
                ReferenceKind::SliderName,
                category,
                place.clone(),
                &category.name,
                &path,
            )
        };
        let packed = asked(".target.gz");
        if packed.found().is_some() {
            packed
        } else {
            Some(asked(".target")).filter(is_found).unwrap_or(packed)
        }
    })
}

fn is_found(reference: &Reference<'_>) -> bool {
    matches!(reference.resolution, Resolution::Found(_))
}

fn reference<'a>(
    catalog: &Catalog<'a>,
    kind: ReferenceKind,
    category: &'a Category,
    place: Place,
    text: &'a str,
    path: &str,
) -> Reference<'a> {
    let base = catalog.file.base_in(OWN).unwrap_or_default();
    let found = Reference::to(
        &[catalog.layer],
        kind,
        base,
        catalog.file,
        place,
        text,
        path.to_owned(),
    );
    let rel = normalized(path).unwrap_or_else(|| path.to_owned());
    Reference {
        owner: &category.name,
        rel,
        ..found
    }
}

fn place(section: &Section, category: &Category, member: &[&str]) -> Place {
    let index = category.index.to_string();
    Place::Pointer(mhlint_diag::pointer(
        &[&[section.name.as_str(), "categories", &index], member].concat(),
    ))
}
