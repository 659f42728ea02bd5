//! The data of MPFB as it sees them (formats/mpfb.md §1, §2). Connected so far: the catalogue of sliders with its targets,
//! what is worn with its weights, and what is found by its name.

mod named;
mod references;
mod view;

pub(crate) use named::NamedTarget;
pub(crate) use view::{Catalog, View};
