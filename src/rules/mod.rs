//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod macros;
mod rule;
mod target;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &macros::alias_suspect::RULE,
    &macros::ambiguous_value::RULE,
    &macros::barycentric_mismatch::RULE,
    &macros::duplicate_combination::RULE,
    &macros::duplicate_value::RULE,
    &macros::empty_target::RULE,
    &macros::folder_missing::RULE,
    &macros::influence_mismatch::RULE,
    &macros::influence_range::RULE,
    &macros::missing_combination::RULE,
    &macros::missing_target::RULE,
    &macros::name_collision::RULE,
    &macros::repeated_component::RULE,
    &macros::steps_and_sum::RULE,
    &macros::steps_length::RULE,
    &macros::steps_order::RULE,
    &macros::steps_range::RULE,
    &macros::sum_arity::RULE,
    &macros::target_extension::RULE,
    &macros::too_many_active::RULE,
    &macros::unexpected_combination::RULE,
    &macros::unknown_component::RULE,
    &macros::unknown_pattern::RULE,
    &macros::unreferenced_target::RULE,
    &macros::unused_component::RULE,
    &target::syntax::RULE,
];
