//! Bytes to models and facts, one format a file, or a folder where it takes several.
//!
//! A parser returns what the application would see, and counts in the same pass everything rules
//! ask about. Nothing is checked here; other files are not known here.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![warn(clippy::indexing_slicing)]

pub mod asset_mesh;
pub mod base_json;
pub mod bone_references;
pub mod bvh;
mod content;
pub mod expression;
pub mod face_expression;
pub mod face_units;
mod faulty_rows;
mod fields;
mod fitting_columns;
pub mod format_text;
pub mod geometry;
pub mod human_preset;
pub mod importer_preset;
pub mod index_table;
pub mod ink_layer;
pub mod inline_ignore;
pub mod json_file;
pub mod look_settings;
pub mod macro_json;
pub mod macro_parts;
pub mod mesh_difference;
pub mod mesh_metadata;
pub mod meta;
pub mod mhbin;
pub mod mhclo;
pub mod mhm;
pub mod mhmat;
pub mod mhpose;
pub mod mhskel;
pub mod mhw;
pub mod modelling;
pub mod modifiers;
pub mod node_tree;
mod npy;
pub mod npz;
mod number;
pub mod obj;
pub mod outdated;
pub mod pack_metadata;
pub mod packed;
mod packed_json;
pub mod pickle;
pub mod picture;
pub mod picture_list;
pub mod pose_units;
pub mod program;
pub mod proxy_corrections;
pub mod randomization;
mod readers;
pub mod rig;
pub mod scene;
pub mod selection_filter;
pub mod shader_source;
pub mod stored_pose;
mod table;
pub mod target;
pub mod target_cat;
pub mod target_catalog;
pub mod unfit;
pub mod uv_layer;
pub mod uv_map;

pub use content::Content;
use number::stored;
pub use number::{python_float, python_int};
pub use readers::{Input, Parsed};
pub use table::FORMATS;
pub use table::Format;
pub use table::Needs;
