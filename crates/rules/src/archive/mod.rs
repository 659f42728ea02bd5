//! Rules on binary archives: of targets, of base meshes and of assets. What is wrong with one is
//! found in one place, and each rule reports its sort of it.

mod compiled;
mod malformed;
mod missing_member;
mod object_array;
mod overflow;
mod pack;
mod packed_targets;
mod path_escape;
mod report;
mod undiscovered;
mod words;
mod worn;
mod wrong_dtype;

use super::Rule;
use mhlint_formats::npz::NpyFault;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &malformed::RULE,
    &missing_member::RULE,
    &object_array::RULE,
    &overflow::RULE,
    &path_escape::RULE,
    &undiscovered::RULE,
    &wrong_dtype::RULE,
];

/// What is wrong with an archive, each a rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sort {
    /// It cannot be opened, or what is in it does not fit together.
    Malformed,
    /// A member does not exist.
    MissingMember,
    /// A member has fields of other types than are read.
    WrongDtype,
    /// A member has Python objects.
    ObjectArray,
}

impl Sort {
    const fn of(fault: &NpyFault) -> Self {
        match fault {
            NpyFault::Object => Self::ObjectArray,
            NpyFault::WrongType(..) | NpyFault::MissingField(_) => Self::WrongDtype,
            _ => Self::Malformed,
        }
    }
}
