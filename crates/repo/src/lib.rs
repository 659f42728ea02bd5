//! Facts of all files, connected: layers, who wins, what refers to what.
//!
//! Gets the facts of each layer and answers as the application would: which file is taken, which
//! folder targets come from, what a name leads to. Knows no bytes and gives no levels. What every
//! application has is here, what one does in its own way is in its folder.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod archived;
pub mod aside;
mod body;
pub mod cubes;
pub mod extent;
mod facts;
mod gaps;
mod landmarks;
mod layer;
mod layers;
pub mod makehuman1;
pub mod makehuman2;
mod misnamed_folder;
pub mod mpfb;
mod pack;
mod path;
mod reference;
mod references;
mod slider_ends;
mod surface;
mod view;
mod worn;

pub use body::{
    Body, BodyPose, BodyWeights, Doubt, PoseUnitsFile, Rig, Shown, StoredBones, Target, WeightsUse,
};
pub use facts::FileFacts;
pub use gaps::Gaps;
pub use landmarks::{Landmarks, Region, Unreached};
pub use layer::{Layer, composed, fold};
pub use layers::Layers;
pub use makehuman2::is_unfiled;
pub use misnamed_folder::MisnamedFolder;
pub use pack::{Import, Names, Pack};
pub use path::shortened;
pub use reference::{PictureFolders, Reference, ReferenceKind, Resolution};
pub use references::References;
pub use surface::{Picture, Shader, Surface, Wearer};
pub use view::View;
pub use worn::{Worn, worn_reader};
