//! Poses and motions.

pub(in crate::rules) mod non_finite;
pub(in crate::rules) mod unknown_bone;
