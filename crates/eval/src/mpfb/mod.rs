//! The formulas of MPFB: shares of macro settings, the loops over their names, the mix of shape
//! keys, what the ranges of a setting cover, bones on the mesh, at rest and in a pose, weights as
//! vertex groups, and assets on the mesh.

pub mod armature;
pub mod cover;
pub mod fit;
pub mod groups;
pub mod identify;
pub mod joints;
pub mod loops;
pub mod mix;
pub mod pose;
pub mod rest;
pub mod shares;

pub use loops::MacroLoops;
