//! Facts of all files, connected: layers, who wins, what refers to what.
//!
//! Gets the facts of each layer and answers as the application would: which file is taken, which
//! folder targets come from, what a name leads to. Knows no bytes and gives no levels. What every application has is
//! here, what one does in its own way is in its folder.

mod archived;
pub(crate) mod aside;
mod body;
pub(crate) mod cubes;
pub(crate) mod extent;
mod facts;
mod gaps;
mod landmarks;
mod layer;
mod layers;
pub(crate) mod makehuman1;
pub(crate) mod makehuman2;
mod misnamed_folder;
pub(crate) mod mpfb;
mod pack;
mod path;
mod reference;
mod references;
mod slider_ends;
mod surface;
mod view;
mod worn;

pub(crate) use body::{Body, BodyPose, BodyWeights, Doubt, PoseUnitsFile, Rig, Shown, StoredBones, Target, WeightsUse};
pub(crate) use facts::FileFacts;
pub(crate) use gaps::Gaps;
pub(crate) use landmarks::{Landmarks, Region, Unreached};
pub(crate) use layer::{Layer, composed, fold};
pub(crate) use layers::Layers;
pub(crate) use makehuman2::is_unfiled;
pub(crate) use misnamed_folder::MisnamedFolder;
pub(crate) use pack::{Import, Names, Pack};
pub(crate) use path::shortened;
pub(crate) use reference::{PictureFolders, Reference, ReferenceKind, Resolution};
pub(crate) use references::References;
pub(crate) use surface::{Picture, Shader, Surface, Wearer};
pub(crate) use view::View;
pub(crate) use worn::Worn;

/// The folder of a path, empty at the top.
pub(crate) fn parent(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}
