//! Motions: `.bvh`.

pub(crate) mod channels;
pub(crate) mod duplicate_joint;
mod frame_fault;
pub(crate) mod frames;
mod imported;
pub(crate) mod syntax;

use super::Rule;
use mhlint_diag::{
    Application::{Makehuman1, Makehuman2},
    Case, Finding, Level,
};
use mhlint_discover::library_of;
use mhlint_repo::{Body, FileFacts};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &channels::RULE,
    &duplicate_joint::RULE,
    &frames::RULE,
    &syntax::RULE,
];

/// What becomes of a file that is rejected inside its hierarchy or later.
const REJECTED: Case = &[(
    Makehuman2,
    Level::Error,
    "rejects the file with a message; playing or exporting it then crashes with `TypeError`",
)];
/// What becomes of a file at which an index or a number fails.
const INDEX: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `IndexError` when the pose is chosen",
)];
const VALUE: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `ValueError` when the pose is chosen",
)];

/// With the motion whose frames are the units of expressions MakeHuman 1 loses these
/// (`docs/loaders/makehuman1/expressions.md#units`).
fn of_units(body: &Body<'_>, file: &FileFacts, finding: Finding) -> Finding {
    let is_of_units = body.is_makehuman1() && library_of(&file.rel).is_none();
    if is_of_units {
        finding.effect_in(Makehuman1, NO_EXPRESSION)
    } else {
        finding
    }
}

const NO_EXPRESSION: &str = "lists the expressions and shows none of them";
