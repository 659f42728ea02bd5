//! Pickles of Python, looked at without running anything
//! (`docs/loaders/makehuman1/scenes.md#danger`).
//!
//! A pickle is a program for a small machine, and some of its instructions import and call what
//! they name. A file is walked twice: first instruction by instruction, to find those; then, only
//! if there are none, with a machine that knows plain values and one class that is asked for.

mod machine;
mod opcode;
mod step;

pub use machine::{Fault, Heap, Node, Value, run};
pub use opcode::Break;
pub use step::{Danger, Walk, walk};

/// The class of colours, the only one that scenes have.
pub const COLOR: (&str, &str) = ("material", "Color");
