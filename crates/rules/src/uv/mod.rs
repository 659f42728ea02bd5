//! Rules on texture coordinates for ink layers of MPFB.

mod layer;
mod stop;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&layer::RULE];
