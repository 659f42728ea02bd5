//! The formulas of MPFB: shares of macro settings, the loops over their names, the mix of shape keys, and what the ranges
//! of a setting cover.

pub mod cover;
pub mod loops;
pub mod mix;
pub mod shares;

pub use loops::MacroLoops;
