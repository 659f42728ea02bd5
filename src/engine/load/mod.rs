//! The loading wing: PATHs to data roots, data roots to layers of facts.

mod data;
mod input;
mod layer;
mod loose;
mod open;
mod read;
mod roots;
mod stack;

pub(super) use data::{Data, Loaded};
pub(super) use input::{Input, open, open_system};
pub(super) use layer::load_targets;
pub(super) use loose::moved;
pub use open::open_base;
pub(super) use roots::{Roots, check_bases, summarise};
