//! Expressions of MPFB: faces made of units.

pub(crate) mod clash;
pub(crate) mod missing_targets;
pub(crate) mod schema;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&clash::RULE, &missing_targets::RULE, &schema::RULE];
