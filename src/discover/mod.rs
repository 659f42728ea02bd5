//! What is where: data roots in a listing, what each path in them is for. Looks at paths only, opens nothing.
//!
//! What an application makes of paths is its [`Layout`]; nothing else here or further up matches parts of paths to find
//! out what a file is for. The code of one application builds the paths of files that it opens by name.

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

pub(crate) use aside::{Aside, TEST_DATA, aside, is_fitting_table};
pub(crate) use candidate::{Candidate, Use, candidates, kind_in, owner_of, uses_of};
pub(crate) use evidence::{Evidence, evidence, lacks};
pub(crate) use kind::{Kind, SHADER_FILES, extension, is_asset_anywhere, meant_extension};
pub(crate) use layout::makehuman1::{TARGETS_NPZ, archive_library_of, libraries, library_extension, library_of};
pub(crate) use layout::makehuman2::importer::{Loss, import, loss, meant_for, new_base, top_folder};
pub(crate) use layout::makehuman2::opened::{SKY_SIDES, in_place_of, is_in_override_folder, listed_in, material_of};
pub(crate) use layout::mpfb::importer::Refusal;
pub(crate) use layout::mpfb::{SAVED_CHARACTER, SKIN_MAPS, STORED_POSE};
pub(crate) use layout::{Layout, Role, Single, is_read_though_hidden};
pub(crate) use listing::Listing;
pub(crate) use loose::{Binding, Known, UNKNOWN_BASE, loose};
pub(crate) use paths::Paths;
pub(crate) use roots::{Meant, find_roots};
