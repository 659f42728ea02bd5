//! The loading wing: PATHs to data roots, data roots to layers of facts.

mod data;
mod input;
mod layer;
mod loose;
pub(in crate::engine) mod read;
mod roots;
mod stack;

pub(super) use data::{Data, Loaded};
pub(super) use input::{Input, open, open_system};
pub(super) use layer::{Place, list_targets, load_targets};
pub(super) use loose::moved;
pub(super) use roots::{Roots, check_bases, roots_of, summarise};
pub(super) use stack::{Role, Stack};
