//! How files of MakeHuman 2 become the arrays that are evaluated, and its kinds of cases.

pub(super) mod asset;
mod base;
pub(super) mod cases;
pub(super) mod compose;
pub(super) mod macros;
mod references;
pub(super) mod skeleton;
pub(super) mod weights;
