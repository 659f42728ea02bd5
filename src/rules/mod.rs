//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod json;
mod macros;
mod overlay;
mod rule;
mod target;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &json::duplicate_key::RULE,
    &json::schema::RULE,
    &json::syntax::RULE,
    &json::too_deep::RULE,
    &json::unknown_key::RULE,
    &macros::steps_length::RULE,
    &overlay::broken_override::RULE,
    &overlay::needs_system::RULE,
    &overlay::partial_override::RULE,
    &overlay::shadowed::RULE,
    &overlay::targets_not_in_layer::RULE,
    &overlay::user_key_clash::RULE,
    &overlay::user_target_too_deep::RULE,
    &target::syntax::RULE,
];
