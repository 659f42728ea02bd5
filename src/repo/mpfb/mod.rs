//! The data of MPFB as it sees them (formats/mpfb.md §1 to §3). Connected so far: the catalogue of sliders and the macros
//! with their targets, and what is worn with its weights.

pub(crate) mod loops;
mod parts;
mod references;
mod view;

pub(crate) use parts::{Parts, Request};
pub(crate) use view::{Catalog, View};
