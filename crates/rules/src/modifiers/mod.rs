//! Modifiers of MakeHuman 1 with their targets, descriptions and sliders.

pub(crate) mod class;
pub(crate) mod companion;
pub(crate) mod default_value;
pub(crate) mod description;
pub(crate) mod duplicate;
pub(crate) mod equal_tails;
pub(crate) mod meant;
pub(crate) mod merged_boxes;
pub(crate) mod no_target;
pub(crate) mod renamed;
pub(crate) mod ruler;
pub(crate) mod second_group;
pub(crate) mod sliders;
mod spellings;
pub(crate) mod symmetric;
pub(crate) mod tab_clash;
pub(crate) mod tails;
pub(crate) mod unread;
pub(crate) mod unused;
pub(crate) mod variable;
pub(crate) mod view;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &class::RULE,
    &companion::RULE,
    &default_value::RULE,
    &description::OF_TYPE,
    &description::RULE,
    &duplicate::RULE,
    &equal_tails::RULE,
    &merged_boxes::RULE,
    &no_target::RULE,
    &renamed::RULE,
    &ruler::RULE,
    &second_group::RULE,
    &sliders::RULE,
    &symmetric::RULE,
    &tab_clash::RULE,
    &tails::RULE,
    &unread::RULE,
    &unused::UNDESCRIBED,
    &unused::WITHOUT_SLIDER,
    &variable::RULE,
    &view::RULE,
];

/// What one bad slider costs (`docs/loaders/makehuman1/modifiers.md#what-a-failing-slider-costs`).
const LOST_TABS: &str = "shows neither the rest of its tab nor the tabs behind it in the file";
/// What one bad modifier costs.
const LOST_FILE: &str = "loads no further modifiers of the file and shows none of its tabs";
