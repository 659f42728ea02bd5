//! Modifiers of MakeHuman 1 with their targets, descriptions and sliders.

pub(in crate::rules) mod class;
pub(in crate::rules) mod companion;
pub(in crate::rules) mod default_value;
pub(in crate::rules) mod description;
pub(in crate::rules) mod duplicate;
pub(in crate::rules) mod equal_tails;
pub(in crate::rules) mod meant;
pub(in crate::rules) mod merged_boxes;
pub(in crate::rules) mod no_target;
pub(in crate::rules) mod renamed;
pub(in crate::rules) mod ruler;
pub(in crate::rules) mod second_group;
pub(in crate::rules) mod sliders;
mod spellings;
pub(in crate::rules) mod symmetric;
pub(in crate::rules) mod tab_clash;
pub(in crate::rules) mod tails;
pub(in crate::rules) mod unread;
pub(in crate::rules) mod unused;
pub(in crate::rules) mod variable;
pub(in crate::rules) mod view;

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

/// What one bad slider costs (makehuman1-observed.md 1.5).
const LOST_TABS: &str = "shows neither the rest of its tab nor the tabs behind it in the file";
/// What one bad modifier costs.
const LOST_FILE: &str = "loads no further modifiers of the file and shows none of its tabs";
