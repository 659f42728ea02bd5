//! Archives, skeletons, meshes, weights, slider settings.

use super::Input;

pub(super) const INPUTS: &[Input] = &[];
