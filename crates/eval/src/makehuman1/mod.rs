//! The formulas of MakeHuman 1: macro variables, weights of targets, weights of bones and what
//! becomes of them on other skeletons, and what it adds to fitting.

pub mod fit;
pub mod modifiers;
pub mod remap;
pub mod variables;
pub mod weights;

pub use modifiers::Modifiers;
