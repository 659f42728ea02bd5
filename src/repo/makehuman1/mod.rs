//! The data of `MakeHuman` 1 as it sees them. Connected so far: its targets with the modifiers and
//! sliders that move them, its libraries, which are what is worn with its materials and weights, skins, and poses.

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

pub(crate) use compiled::{named_by_archive, narrow_mesh};
pub(crate) use library::{Asset, Known};
pub(crate) use models::{SavedModel, Version, material, uuid_of};
pub(crate) use modifiers::{KnownModifier, SETS, VARIABLES, category};
pub(crate) use program::has_most_of_program;
pub(crate) use target_archive::{TargetArchive, Unused};
pub(crate) use targets::{CUSTOM, CustomTarget, NamedTarget, PathClash, is_own_target};
pub(crate) use view::mesh_archive;
pub(crate) use view::{HIDDEN, View, is_checked, mesh, shows, worn};
