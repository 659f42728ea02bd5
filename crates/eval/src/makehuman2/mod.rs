//! The formulas of MakeHuman 2: macros, joints, rest pose, weights as moved to other skeletons, and
//! what it adds to fitting.

pub mod budget;
pub mod component;
pub mod fit;
pub mod joints;
pub mod macro_def;
pub mod macro_eval;
pub mod macro_survey;
pub mod macro_table;
pub mod rest;
pub mod transfer;

pub use macro_eval::MacroResult;
pub use macro_table::{MacroError, MacroTable};
