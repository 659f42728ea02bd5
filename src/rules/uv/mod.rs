//! Rules on texture coordinates for ink layers of MPFB.

pub(in crate::rules) mod layer;
