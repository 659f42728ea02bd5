//! Finds data roots in a listing, and tells what each path in them is used for. Looks at paths only
//! and opens no files.
//!
//! How an application reads paths is described by its [`Layout`]. No other code here or in the
//! members that build on this one takes paths apart to find out what a file is for. The code of an
//! application may build the paths of files that the application opens by name.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod aside;
mod asset_group;
mod candidate;
mod contest;
mod evidence;
mod kind;
mod layout;
mod listing;
mod loose;
mod paths;
mod roots;

pub use aside::{Aside, TEST_DATA, aside, is_fitting_table};
pub use candidate::{Candidate, Use, candidates, is_of_macos, kind_in, owner_of, uses_of};
pub use evidence::{Evidence, evidence, lacks};
pub use kind::{Kind, SHADER_FILES, is_asset_anywhere, meant_extension};
pub use layout::makehuman1::{
    TARGETS_NPZ, archive_library_of, libraries, library_extension, library_of,
};
pub use layout::makehuman2::importer::{Loss, import, loss, meant_for, new_base, top_folder};
pub use layout::makehuman2::opened::{
    SKY_SIDES, in_place_of, is_in_override_folder, listed_in, material_of,
};
pub use layout::mpfb::importer::Refusal;
pub use layout::mpfb::{SAVED_CHARACTER, SKIN_MAPS, STORED_POSE};
pub use layout::{Layout, Role, Single, is_read_though_hidden};
pub use listing::Listing;
pub use loose::{Binding, Known, UNKNOWN_BASE, loose};
pub use mhlint_source::extension;
pub use paths::Paths;
pub use roots::{Meant, find_roots};
