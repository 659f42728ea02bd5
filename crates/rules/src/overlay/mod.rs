//! Rules on overrides: contarget over target, user over system
//! (`docs/loaders/makehuman2/folders.md#overlays`).

mod base_folder_missing;
mod broken_override;
mod empty_target_folder;
mod partial_override;
mod shadowed;
mod shadowed_asset;
mod targets_alone;
mod targets_not_in_layer;
mod user_key_clash;
mod user_target_too_deep;

use super::Rule;
use super::cause::overlay::{
    SystemFolder, has_broken_override, has_misnamed_override, is_active, lacks_folder,
    system_folder,
};
use mhlint_repo::makehuman2::{Base, Overlaid, View};
use mhlint_repo::{FileFacts, Reference, Resolution};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &base_folder_missing::RULE,
    &broken_override::RULE,
    &empty_target_folder::RULE,
    &partial_override::RULE,
    &shadowed::RULE,
    &shadowed_asset::RULE,
    &targets_not_in_layer::RULE,
    &user_key_clash::RULE,
    &user_target_too_deep::RULE,
];

/// One of the three files that contarget can override, whatever is in it.
struct Override<'a> {
    /// Its name.
    name: &'static str,
    /// The file in contarget.
    file: Option<&'a FileFacts>,
    /// Whether the file in contarget is in use.
    active: bool,
    /// The system's file, if the application would accept it.
    system: Option<&'a FileFacts>,
}

/// `macro.json`, `modelling.json` and `target_cat.json` of a base.
fn overrides<'a>(base: &Base<'a>) -> [Override<'a>; 3] {
    fn of<'a, T>(name: &'static str, both: &Overlaid<'a, T>) -> Override<'a> {
        let system = both.system.accepted().map(|(file, _)| file);
        Override {
            name,
            file: both.contarget.file(),
            active: is_active(both),
            system,
        }
    }
    [
        of("macro.json", &base.macros),
        of("modelling.json", &base.modelling),
        of("target_cat.json", &base.categories),
    ]
}

/// Whether everything that the application takes from contarget is there and fits: sliders and
/// macros, sound, with all their targets. What is wrong with an override has a finding of its own.
fn is_complete(view: &View<'_>, base: &Base<'_>) -> bool {
    let [macros, sliders, _] = overrides(base);
    macros.active
        && sliders.active
        && !has_broken_override(base)
        && in_other_layer(view, base).next().is_none()
}

/// Targets that exist in the layer that lost and not in the one in use.
fn in_other_layer<'s, 'a>(
    view: &'s View<'a>,
    base: &'s Base<'a>,
) -> impl Iterator<Item = &'s Reference<'a>> {
    let references = view.references_of(base);
    references.filter(|reference| {
        reference.kind.is_target() && matches!(reference.resolution, Resolution::OtherLayer(_))
    })
}
