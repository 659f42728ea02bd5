//! The data of MPFB as it sees them (formats/mpfb.md §1, §2). Connected so far: the catalogue of sliders with its targets,
//! and what is worn with its weights.

mod references;
mod view;

pub(crate) use view::{Catalog, View};
