//! Expressions of MPFB: faces made of units.

pub(in crate::rules) mod clash;
pub(in crate::rules) mod missing_targets;
pub(in crate::rules) mod schema;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&clash::RULE, &missing_targets::RULE, &schema::RULE];
