//! Rules on the macro settings of MPFB: `macro.json`, its parts, and the targets that their names
//! are composed to.

mod coverage;
mod discontinuity;
mod empty_range;
mod end_share;
mod gap;
mod missing_setting;
mod missing_target;
mod name_patterns;
mod overlap;
mod reversed;
mod stretch;
mod unknown_combination;
mod wanted;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &coverage::RULE,
    &discontinuity::RULE,
    &empty_range::RULE,
    &end_share::RULE,
    &gap::RULE,
    &missing_setting::RULE,
    &missing_target::RULE,
    &overlap::RULE,
    &reversed::RULE,
    &unknown_combination::RULE,
];
