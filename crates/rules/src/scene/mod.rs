//! Rules on scenes of MakeHuman 1, and on the lists of its libraries: pickles, both of them.

mod malformed;
mod unsafe_pickle;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&malformed::RULE, &unsafe_pickle::RULE];

/// The scene that the program starts with.
const FIRST: &str = "scenes/default.mhscene";
