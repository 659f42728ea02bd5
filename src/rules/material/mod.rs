//! Materials: `.mhmat`.

mod advice;
pub(in crate::rules) mod missing_texture;
