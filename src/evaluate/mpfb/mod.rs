//! How files of MPFB become the arrays that are evaluated, and its kinds of cases.

pub(super) mod base;
pub(super) mod cases;
mod keys;
pub(super) mod macros;
pub(super) mod names;

use super::Error;

/// Rigs of MPFB follow formulas of their own.
pub(super) fn no_rigs(base: &str) -> Error {
    Error::NoSkeleton { base: base.to_owned(), reason: NO_RIGS.to_owned() }
}

const NO_RIGS: &str = "mhlint cannot evaluate rigs of MPFB yet";
