//! Expressions of MPFB: faces made of units.

pub(in crate::rules) mod clash;
pub(in crate::rules) mod missing_targets;
pub(in crate::rules) mod schema;
