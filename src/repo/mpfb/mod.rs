//! The data of MPFB as it sees them (formats/mpfb.md §1, §2). Connected so far: the catalogue of sliders with its targets,
//! and what is worn with its weights.

mod references;
mod sliders;
mod view;

pub(crate) use sliders::{LONGEST, LONGEST_SECTION, LONGEST_SECTION_WITH_SLIDERS, UserTarget, identifiers, pair};
pub(crate) use view::{Catalog, View};
