//! How files of MakeHuman 1 become the arrays that are evaluated: so far those of what is worn.

mod asset;
pub(super) mod worn;

pub use asset::{Asset, read_asset};
