//! Rules on binary archives: of targets, of base meshes and of assets. What is wrong with one is found in one place, and
//! each rule reports its sort of it.

pub(super) mod malformed;
pub(super) mod missing_member;
pub(super) mod object_array;
mod pack;
pub(super) mod path_escape;
mod report;
mod words;
mod worn;
pub(super) mod wrong_dtype;

use crate::formats::npz::NpyFault;

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
