//! Saved characters: `.mhm`.

pub(in crate::rules) mod arity;
pub(in crate::rules) mod category;
mod known_pattern;
mod makehuman1;
pub(in crate::rules) mod material;
pub(in crate::rules) mod modifier;
mod modifier_repeated;
mod modifier_value;
mod mpfb_asset;
mod mpfb_lines;
mod mpfb_modifier;
mod short_lines;
pub(in crate::rules) mod syntax;
pub(in crate::rules) mod tags;
pub(in crate::rules) mod unknown_asset;
mod unparted;
pub(in crate::rules) mod version;

use super::Rule;
use crate::repo::makehuman2::{Base, SavedModel, View};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &arity::RULE,
    &category::RULE,
    &material::RULE,
    &modifier::RULE,
    &syntax::RULE,
    &tags::RULE,
    &unknown_asset::RULE,
    &version::RULE,
];

/// The characters of a base that are checked.
fn own<'v>(view: &'v View<'_>, base: &Base<'_>) -> impl Iterator<Item = &'v SavedModel<'v>> {
    view.models_of(base).iter().filter(|one| view.layers.is_checked(one.file) && !one.file.failed)
}

/// When what is wrong with a character is met.
fn when(model: &SavedModel<'_>) -> &'static str {
    if model.is_start { "at start" } else { "when the model is loaded" }
}
