//! Ink layers of MPFB: pictures over the skin.

pub(in crate::rules) mod layer;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&layer::RULE];
