//! Saved characters as MakeHuman 1 reads them (`docs/loaders/makehuman1/models.md#model-keywords`,
//! `docs/loaders/makehuman1/models.md#version-of-a-model`,
//! `docs/loaders/makehuman1/models.md#faults-of-models`).

pub(super) mod arity;
pub(super) mod assets;
pub(super) mod keyword;
pub(super) mod material;
pub(super) mod modifier;
pub(super) mod tags;

use mhlint_repo::makehuman1::{SavedModel, Version, View};

/// The checked models whose version the program reads.
fn own<'v, 'a>(view: &'v View<'a>) -> impl Iterator<Item = &'v SavedModel<'a>> {
    view.models
        .iter()
        .filter(|model| view.layers.is_checked(model.file) && model.version.is_read())
}

/// The checked models whose lines have the form of the current version.
fn current<'v, 'a>(view: &'v View<'a>) -> impl Iterator<Item = &'v SavedModel<'a>> {
    own(view).filter(|model| model.version == Version::Current)
}
