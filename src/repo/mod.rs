//! Facts of all files, connected: layers, who wins, what refers to what.
//!
//! Gets the facts of each layer and answers as the application would: which file is taken, which
//! folder targets come from, what a name leads to. Knows no bytes and gives no levels. What every application has is
//! here, what one does in its own way is in its folder.

mod body;
mod facts;
mod layer;
mod layers;
pub mod makehuman1;
pub mod makehuman2;
pub mod mpfb;
mod path;
mod reference;
mod references;
mod view;

pub use body::{Body, BodyWeights, Rig, Shown, Target};
pub use facts::FileFacts;
pub use layer::{Layer, composed, fold};
pub use layers::Layers;
pub use reference::{Reference, ReferenceKind, Resolution};
pub use references::References;
pub use view::View;

/// The folder of a path, empty at the top.
pub fn parent(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}
