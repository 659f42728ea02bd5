//! The files on sliders of MakeHuman 1: what they move, where they stand, what is said of them, and
//! what they were called before.

pub mod file;
pub mod mapping;
pub mod sliders;
pub mod texts;
