//! Rules on `macro.json` of MakeHuman 2.

mod absence;
mod absence_text;
pub(super) mod combination_patterns;
mod component;
mod fit;
mod holders;
mod homes;
mod lacking_component;
mod links;
mod listing;
mod lost_folder;
mod misspelt_value;
mod sound;
mod space;
mod spelled;
mod survey;
mod suspects;
mod titles;

mod alias_suspect;
mod ambiguous_value;
mod barycentric_mismatch;
mod duplicate_combination;
mod duplicate_value;
mod empty_target;
mod folder_missing;
mod influence_mismatch;
mod influence_range;
mod missing_combination;
mod missing_target;
mod name_collision;
mod repeated_component;
mod steps_and_sum;
mod steps_length;
mod steps_order;
mod steps_range;
mod sum_arity;
mod target_extension;
mod too_many_active;
mod unexpected_combination;
mod unknown_component;
mod unknown_pattern;
mod unreferenced_target;
mod unused_component;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &alias_suspect::RULE,
    &ambiguous_value::RULE,
    &barycentric_mismatch::RULE,
    &duplicate_combination::RULE,
    &duplicate_value::RULE,
    &empty_target::RULE,
    &folder_missing::RULE,
    &influence_mismatch::RULE,
    &influence_range::RULE,
    &missing_combination::RULE,
    &missing_target::RULE,
    &name_collision::RULE,
    &repeated_component::RULE,
    &steps_and_sum::RULE,
    &steps_length::RULE,
    &steps_order::RULE,
    &steps_range::RULE,
    &sum_arity::RULE,
    &target_extension::RULE,
    &too_many_active::RULE,
    &unexpected_combination::RULE,
    &unknown_component::RULE,
    &unknown_pattern::RULE,
    &unreferenced_target::RULE,
    &unused_component::RULE,
];
