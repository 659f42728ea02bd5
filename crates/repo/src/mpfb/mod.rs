//! The data of MPFB as it sees them (`docs/loaders/mpfb/folders.md#lookups`). Connected so far: the
//! catalogue of sliders and the macros with their targets, rigs and what is worn with their
//! weights, and what is found by its name.

mod looks;
pub mod loops;
pub mod misplaced;
mod named;
mod offered;
mod parts;
mod references;
mod rigs;
mod sliders;
mod view;

pub use looks::{Look, Set};
pub use named::{NamedTarget, uuid};
pub use offered::lost_rigs;
pub use parts::{Parts, Request};
pub use rigs::{POSE_ENDINGS, RigFile, RigPart, is_listed, rig_of_pose};
pub use sliders::{
    LONGEST, LONGEST_SECTION, LONGEST_SECTION_WITH_SLIDERS, UserTarget, ends, identifier,
    identifiers, is_custom, pair,
};
pub use view::{Catalog, View};
