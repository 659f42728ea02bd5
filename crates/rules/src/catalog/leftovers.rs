//! Entries of `targets` that name no file and that no slider asks for.

use std::collections::BTreeSet;

use super::super::Rule;
use super::place;
use mhlint_diag::{Evidence, Finding, Level};
use mhlint_formats::target_catalog::Section;
use mhlint_repo::mpfb::Catalog;

/// One finding for those of a section.
pub(super) fn finding(rule: &Rule, catalog: &Catalog<'_>, section: &Section) -> Option<Finding> {
    let slots = section
        .categories
        .iter()
        .flat_map(|category| category.slots.iter().flatten());
    let asked: BTreeSet<&str> = slots.map(|slot| slot.stem.as_str()).collect();
    let simple = section
        .categories
        .iter()
        .filter(|category| category.slots.is_none());
    let named: BTreeSet<String> = simple
        .flat_map(|one| {
            one.sides()
                .iter()
                .map(move |side| format!("{side}{}", one.name))
        })
        .collect();
    let is_left = |name: &str| {
        !asked.contains(name)
            && !named.contains(name)
            && catalog.target(&section.name, name).is_none()
    };
    let entries = section
        .categories
        .iter()
        .flat_map(|one| one.targets.iter().map(move |(at, name)| (one, at, name)));
    let left: Vec<_> = entries.filter(|(_, _, name)| is_left(name)).collect();
    let (category, at, name) = *left.first()?;
    let place = place(section, Some(category), &["targets", &at.to_string()]);
    let message = match left.len() {
        1 => format!("`targets` lists `{name}`, which does not exist and is not used by a slider"),
        many => format!(
            "`targets` lists {many} files in section `{}` that do not exist and are not used by a \
                slider",
            section.name
        ),
    };
    let finding = rule
        .at(catalog.file, place, message)
        .key(format!("{} targets", section.name));
    let finding = finding
        .level(Level::Info)
        .effect("ignores the entry: it finds targets by slots and names");
    Some(
        finding
            .help(if left.len() == 1 {
                "remove the entry"
            } else {
                "remove the entries"
            })
            .evidence(Evidence::of_cases(left.iter().map(|(.., name)| name))),
    )
}
