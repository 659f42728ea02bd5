//! The data of `MakeHuman` 2, connected as it does: contarget over target, the user's sliders merged on top, names of
//! files in macros, sliders, skeletons, materials and `base.json`.

mod base;
mod foreign;
mod intent;
mod known;
mod library;
mod macro_folders;
mod meshes;
mod misnamed;
mod models;
mod overlay;
mod poses;
mod program;
mod references;
mod rigs;
mod shown;
mod slider;
mod surfaces;
mod target_folder;
mod textures;
mod unfiled;
mod usage;
pub(crate) mod user_scan;
mod view;
mod weights;
mod worn;

pub(crate) use base::Base;
pub(crate) use foreign::{ForeignMesh, ForeignSign};
pub(crate) use library::{Asset, Library};
pub(crate) use macro_folders::is_beneath;
pub(crate) use meshes::{Lies, MeshFiles, UnreadMesh};
pub(crate) use models::SavedModel;
pub(crate) use overlay::{Candidate, Overlaid};
pub(crate) use program::{PROGRAM_FILES, has_shaders, holds_program, lacks_bases};
pub(crate) use slider::{BoundSlider, Pattern};
pub(crate) use target_folder::TargetFolder;
pub(in crate::repo) use textures::folders as picture_folders;
pub(crate) use unfiled::is_unfiled;
pub(crate) use view::View;
pub(crate) use worn::worn;

use crate::diag::Application;

/// Whose uses of a file count here.
const OWN: Application = Application::Makehuman2;
