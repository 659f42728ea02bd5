//! What is done with findings after the rules have run: levels, ignores, scope, baseline,
//! fingerprints, places and order.
//!
//! Imports no other folder of the engine; what it needs of a run comes as arguments.

mod answered;
mod baseline;
mod compare;
mod folder;
mod identify;
mod idle;
mod ignore;
mod keep;
mod known;
mod locate;
mod named;
mod scope;
mod select;

pub(super) use compare::{gone_and_smaller, new_or_worse};
pub(super) use identify::{Placed, Root};
pub(super) use idle::idle;
pub(super) use ignore::Ignores;
pub(super) use keep::Keeper;
pub(super) use known::Known;
pub(super) use locate::place_and_sort;
pub(super) use scope::Scope;
pub(super) use select::{Selection, Verdict};
