//! Saved characters of MPFB: `human.<name>.json`.

mod names;
pub(in crate::rules) mod not_listed;
pub(in crate::rules) mod schema;
