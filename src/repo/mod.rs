//! Facts of all files, connected: layers, who wins, what refers to what.
//!
//! Gets the facts of each layer and answers as the application would: which file is taken, which
//! folder targets come from, what a name leads to. Knows no bytes and makes no judgement.

mod base;
mod facts;
mod intent;
mod layer;
mod overlay;
mod reference;
mod slider;

pub use base::{Base, is_beneath};
pub use facts::FileFacts;
pub use layer::{Layer, Repository, TargetFolder, composed, fold};
pub use overlay::{Candidate, Overlaid};
pub use reference::{Reference, ReferenceKind, Resolution};
pub use slider::{BoundSlider, Pattern};
