//! The data of MPFB as it sees them (formats/mpfb.md §1 to §3). Connected so far: the catalogue of sliders and the macros
//! with their targets, and what is worn with its weights.

pub(crate) mod loops;
mod parts;
mod references;
mod sliders;
mod view;

pub(crate) use parts::{Parts, Request};
pub(crate) use sliders::{LONGEST, LONGEST_SECTION, LONGEST_SECTION_WITH_SLIDERS, UserTarget, identifiers, pair};
pub(crate) use view::{Catalog, View};
