//! Settings, names, formulas, texts in JSON.

use super::Input;

pub(super) const INPUTS: &[Input] = &[];
