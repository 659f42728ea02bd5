//! Saved characters: `.mhm`.

pub(crate) mod arity;
pub(crate) mod category;
mod known_pattern;
mod makehuman1;
pub(crate) mod material;
mod missing_file;
pub(crate) mod modifier;
mod modifier_repeated;
mod modifier_unknown;
mod modifier_value;
mod mpfb_asset;
mod mpfb_lines;
mod mpfb_modifier;
mod offered;
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

/// The models of a base mesh that are checked.
fn own<'v>(view: &'v View<'_>, base: &Base<'_>) -> impl Iterator<Item = &'v SavedModel<'v>> {
    view.models_of(base)
        .iter()
        .filter(|one| view.layers.is_checked(one.file) && !one.file.failed)
}

/// When the application meets a fault in a model, in words.
fn when(model: &SavedModel<'_>) -> &'static str {
    if model.is_start {
        "at start"
    } else {
        "when the model is loaded"
    }
}

/// The help for a line that names an asset which has another name now. If the model has a material
/// line for the asset the name is in that line, too.
fn renamed_line(line: &WornLine, asset: &Asset<'_>, has_material: bool) -> String {
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
