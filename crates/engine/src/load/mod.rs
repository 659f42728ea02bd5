//! The loading wing: PATHs to data roots, data roots to layers of facts.
//!
//! Knows applications by their layouts only: what is loaded has the kinds and owners that these
//! give it.

mod copy;
mod data;
mod found;
mod identify;
mod input;
mod layer;
mod loose;
mod narrow;
mod open;
mod pack;
mod place;
mod proposal;
mod read;
mod roots;
mod set_aside;
mod side;
mod singly;
mod stack;
mod taken;
mod unit_names;

pub(super) use data::{Data, Loaded};
pub(super) use input::Input;
pub use input::is_pack;
pub use open::open_base;
pub use proposal::{Proposal, propose};
pub(super) use roots::{Roots, shown};
pub(super) use side::{Side, sides};
pub(super) use stack::Stack;
