//! Saved characters of MPFB: `human.<name>.json`.

mod names;
pub(crate) mod not_listed;
pub(crate) mod schema;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&not_listed::RULE, &schema::RULE];
