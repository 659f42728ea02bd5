//! Rules on texture coordinates for ink layers of MPFB.

mod layer;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&layer::RULE];
