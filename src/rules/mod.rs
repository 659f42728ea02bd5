//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod base;
mod macros;
mod modelling;
mod rule;
mod target;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &base::barycentric_presets::RULE,
    &base::geometry_range::RULE,
    &base::missing_file::RULE,
    &base::unknown_equipment::RULE,
    &base::unknown_preset::RULE,
    &base::unsafe_rule::RULE,
    &base::vertex_count::RULE,
    &macros::steps_length::RULE,
    &modelling::barycentric_arity::RULE,
    &modelling::blank_in_name::RULE,
    &modelling::decr_only::RULE,
    &modelling::default_range::RULE,
    &modelling::duplicate_pattern::RULE,
    &modelling::empty_category::RULE,
    &modelling::macro_without_influence::RULE,
    &modelling::measure::RULE,
    &modelling::missing_icon::RULE,
    &modelling::missing_target::RULE,
    &modelling::no_effect::RULE,
    &modelling::one_sided_symmetry::RULE,
    &modelling::opposites::RULE,
    &modelling::text_slot::RULE,
    &modelling::unknown_group::RULE,
    &modelling::unknown_symmetry::RULE,
    &modelling::unsafe_formula::RULE,
    &modelling::user_key_collision::RULE,
    &target::syntax::RULE,
];
