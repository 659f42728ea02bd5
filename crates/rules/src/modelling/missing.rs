//! Files of sliders that do not exist, one cause at a time: a folder that is missing as a whole is
//! one.

use std::collections::BTreeMap;

use mhlint_diag::Suggestions;
use mhlint_formats::Format;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};
use mhlint_source::{file_name, parent};

/// Missing files that have one cause.
pub(super) struct Group<'r, 'a> {
    /// The folder, relative to its data root, if nothing at all is in it.
    pub(super) folder: Option<String>,
    /// The references, in order; never empty.
    pub(super) references: Vec<&'r Reference<'a>>,
}

/// References of the wanted kinds that lead to nothing, in order of their first appearance.
pub(super) fn groups<'r, 'a>(
    view: &'r View<'a>,
    base: &'r Base<'a>,
    wanted: fn(ReferenceKind) -> bool,
) -> Vec<Group<'r, 'a>> {
    let mut groups: Vec<Group<'r, 'a>> = Vec::new();
    let mut by_folder: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let references = view
        .references_of(base)
        .filter(|reference| wanted(reference.kind));
    for reference in references.filter(|reference| is_missing(base, reference)) {
        let folder = parent(&reference.rel);
        if !is_empty(view, folder) {
            groups.push(Group {
                folder: None,
                references: vec![reference],
            });
            continue;
        }
        let at = *by_folder
            .entry((reference.from.path.as_str(), folder))
            .or_insert_with(|| {
                groups.push(Group {
                    folder: Some(folder.to_owned()),
                    references: Vec::new(),
                });
                groups.len() - 1
            });
        if let Some(group) = groups.get_mut(at) {
            group.references.push(reference);
        }
    }
    for group in &mut groups {
        if group.references.len() == 1 {
            group.folder = None;
        }
    }
    groups
}

/// Whether there is nothing. A picture that only the system has does not count where sliders and
/// folder are those of an override; of a target in the wrong layer the rules on overlays speak.
fn is_missing(base: &Base<'_>, reference: &Reference<'_>) -> bool {
    match reference.resolution {
        Resolution::Missing => true,
        Resolution::OtherLayer(_) => {
            let overridden = base.macros.is_overridden() && base.modelling.is_overridden();
            reference.kind == ReferenceKind::Icon && overridden
        }
        _ => false,
    }
}

fn is_empty(view: &View<'_>, folder: &str) -> bool {
    view.layers
        .strongest_first()
        .all(|layer| layer.below(folder).next().is_none())
}

/// The file beside a missing one that is most like it, by name without folder.
pub(super) fn nearest<'a>(
    view: &View<'a>,
    reference: &Reference<'_>,
    suggestions: &Suggestions,
) -> Option<&'a str> {
    let folder = parent(&reference.rel);
    let wanted = file_name(&reference.rel);
    // Editors on Windows put a second suffix behind the name: the file is the one that is meant.
    let is_free = |file: &&FileFacts| !Format::of(file.kind).is_json() && !is_used(view, file);
    let doubled = format!("{}.txt", reference.rel);
    let mut doubled = view
        .layers
        .strongest_first()
        .filter_map(|layer| layer.file(&doubled))
        .filter(is_free);
    if let Some(file) = doubled.next() {
        return Some(file.file_name());
    }
    if suggestions.are_over() {
        return None;
    }
    let files = view
        .layers
        .strongest_first()
        .flat_map(|layer| layer.below(folder));
    let free = suggestions.looked_through(files).filter(is_free);
    suggestions.nearest_file(wanted, free.map(FileFacts::file_name))
}

/// Whether something uses a target already. It is not meant: the other side or the other direction
/// often has nearly the same name.
fn is_used(view: &View<'_>, file: &FileFacts) -> bool {
    view.references
        .to_file(file)
        .any(|reference| reference.kind.is_target() && reference.found().is_some())
}
