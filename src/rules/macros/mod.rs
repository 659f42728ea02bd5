//! Rules on `macro.json` of MakeHuman 2.

mod absence;
mod combination_patterns;
mod component;
mod fit;
mod judgeable;
mod links;
mod listing;
mod misspelt_value;
mod space;
mod spelled;
mod survey;

pub(super) mod alias_suspect;
pub(super) mod ambiguous_value;
pub(super) mod barycentric_mismatch;
pub(super) mod duplicate_combination;
pub(super) mod duplicate_value;
pub(super) mod empty_target;
pub(super) mod folder_missing;
pub(super) mod influence_mismatch;
pub(super) mod influence_range;
pub(super) mod missing_combination;
pub(super) mod missing_target;
pub(super) mod name_collision;
pub(super) mod repeated_component;
pub(super) mod steps_and_sum;
pub(super) mod steps_length;
pub(super) mod steps_order;
pub(super) mod steps_range;
pub(super) mod sum_arity;
pub(super) mod target_extension;
pub(super) mod too_many_active;
pub(super) mod unexpected_combination;
pub(super) mod unknown_component;
pub(super) mod unknown_pattern;
pub(super) mod unreferenced_target;
pub(super) mod unused_component;
