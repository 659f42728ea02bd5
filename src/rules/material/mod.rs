//! Materials: `.mhmat`.

pub(in crate::rules) mod missing_texture;
