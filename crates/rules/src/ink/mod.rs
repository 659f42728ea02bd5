//! Ink layers of MPFB: pictures over the skin.

pub(crate) mod layer;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&layer::RULE];
