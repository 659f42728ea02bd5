//! Motions: `.bvh`.

pub(in crate::rules) mod channels;
pub(in crate::rules) mod duplicate_joint;
pub(in crate::rules) mod frames;
mod imported;
pub(in crate::rules) mod syntax;

use super::Rule;
use crate::diag::{Application::Makehuman2, Case, Level};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&channels::RULE, &duplicate_joint::RULE, &frames::RULE, &syntax::RULE];

/// What becomes of a file that is rejected inside its hierarchy or later.
const REJECTED: Case = &[(
    Makehuman2,
    Level::Error,
    "rejects the file with a message; playing or exporting it then crashes with `TypeError`",
)];
/// What becomes of a file at which an index or a number fails.
const INDEX: Case = &[(Makehuman2, Level::Error, "crashes with `IndexError` when the pose is chosen")];
const VALUE: Case = &[(Makehuman2, Level::Error, "crashes with `ValueError` when the pose is chosen")];
