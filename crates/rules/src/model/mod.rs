//! Saved characters: `.mhm`.

pub(crate) mod arity;
pub(crate) mod category;
mod known_pattern;
mod makehuman1;
pub(crate) mod material;
pub(crate) mod modifier;
mod modifier_repeated;
mod modifier_value;
mod mpfb_asset;
mod mpfb_lines;
mod mpfb_modifier;
mod short_lines;
pub(crate) mod syntax;
pub(crate) mod tags;
pub(crate) mod unknown_asset;
mod unparted;
pub(crate) mod version;

use super::Rule;
use mhlint_formats::mhm::WornLine;
use mhlint_repo::makehuman2::{Asset, Base, SavedModel, View};

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
    view.models_of(base)
        .iter()
        .filter(|one| view.layers.is_checked(one.file) && !one.file.failed)
}

/// When what is wrong with a character is met.
fn when(model: &SavedModel<'_>) -> &'static str {
    if model.is_start {
        "at start"
    } else {
        "when the model is loaded"
    }
}

/// What to write where an asset goes by another name now. The line of its material names it as
/// well.
fn renamed_line(saved: &SavedModel<'_>, line: &WornLine, asset: &Asset<'_>) -> String {
    let has_material = saved
        .model
        .materials
        .iter()
        .any(|other| other.name.text == line.name.text);
    let also = if has_material {
        ", and the new name in the line of its material"
    } else {
        ""
    };
    format!(
        "write `{} {} {}`{also}",
        line.category.text, asset.name, asset.uuid
    )
}
