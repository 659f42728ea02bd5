//! The data of `MakeHuman` 1 as it sees them. Connected so far: its targets with the modifiers and
//! sliders that move them, its libraries, which are what is worn with its materials and weights,
//! skins, and poses.

mod compiled;
mod expressions;
mod library;
mod models;
mod modifiers;
mod program;
mod rigs;
mod search;
mod surfaces;
mod target_archive;
mod targets;
mod view;

pub use compiled::{named_by_archive, narrow_mesh};
pub use library::{Asset, Known};
pub use models::{SavedModel, Version, material, uuid_of};
pub use modifiers::{KnownModifier, SETS, VARIABLES, category};
pub use program::has_most_of_program;
pub use target_archive::{TargetArchive, Unused};
pub use targets::{CUSTOM, CustomTarget, NamedTarget, PathClash, is_own_target};
pub use view::mesh_archive;
pub use view::{ForeignSign, HIDDEN, View, is_checked, mesh, shows, worn};
