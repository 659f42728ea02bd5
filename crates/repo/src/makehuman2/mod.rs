//! The data of `MakeHuman` 2, connected as it does: contarget over target, the user's sliders
//! merged on top, names of files in macros, sliders, skeletons, materials and `base.json`.

mod base;
mod foreign;
mod intent;
mod known;
mod library;
mod macro_folders;
mod meshes;
mod misnamed;
mod models;
mod orphaned;
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
pub mod user_scan;
mod view;
mod weights;
mod worn;

pub use base::Base;
pub use foreign::{ForeignMesh, ForeignSign};
pub use library::{Asset, Library};
pub use macro_folders::is_beneath;
pub use meshes::{Lies, MeshFiles, UnreadMesh};
pub use models::SavedModel;
pub use overlay::{Candidate, Overlaid};
pub use program::{PROGRAM_FILES, has_shaders, holds_program, lacks_bases};
pub use slider::{BoundSlider, Pattern, Undeclared, as_undeclared};
pub use target_folder::TargetFolder;
pub(crate) use textures::folders as picture_folders;
pub use unfiled::is_unfiled;
pub use view::View;
pub use worn::worn;

use mhlint_diag::Application;

/// Whose uses of a file count here.
const OWN: Application = Application::Makehuman2;
