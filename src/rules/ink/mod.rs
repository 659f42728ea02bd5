//! Ink layers of MPFB: pictures over the skin.

pub(in crate::rules) mod layer;
