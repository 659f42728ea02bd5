//! Rules on the sliders of MPFB: `target.json`, the catalogue.

pub(super) mod missing_target;
mod neighbours;
