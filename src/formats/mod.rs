//! Bytes to models and facts, one format a file.
//!
//! A parser returns what the application would see, and counts in the same
//! pass everything rules ask about. Nothing is checked here; other files are not known here.
#![warn(clippy::indexing_slicing)]

pub mod asset_mesh;
pub mod base_json;
pub mod bvh;
pub mod bvh_blender;
mod content;
mod content_hash;
pub mod expression;
pub mod face_expression;
mod faulty_rows;
mod fields;
pub(crate) mod format_text;
pub mod geometry;
pub mod human_preset;
pub mod importer_preset;
pub mod index_table;
pub mod ink_layer;
pub(crate) mod inline_ignore;
pub(crate) mod json_file;
pub mod look_settings;
pub mod macro_json;
pub mod macro_parts;
pub mod mesh_difference;
pub mod mesh_metadata;
pub mod meta;
pub mod mhbin;
pub mod mhbin_asset;
pub mod mhclo;
pub mod mhm;
pub mod mhm_columns;
pub mod mhmat;
pub mod mhpose;
pub mod mhskel;
pub mod mhw;
pub(crate) mod mhw_edit;
mod mhw_facts;
mod mhw_sums;
pub mod modelling;
pub mod node_tree;
mod npy;
mod npy_header;
mod npy_table;
pub mod npz;
mod npz_samples;
mod number;
pub mod obj;
mod obj_facts;
pub(crate) mod obj_text;
pub mod pack_metadata;
mod packed_json;
mod packed_rows;
pub mod picture;
pub mod pose_units;
pub mod program;
pub mod proxy_corrections;
mod readers;
pub mod rig;
pub mod selection_filter;
pub mod shader_source;
pub mod stored_pose;
mod table;
pub mod target;
mod target_blanks;
pub mod target_cat;
pub mod target_catalog;
pub(crate) mod target_edit;
mod target_facts;
mod target_repeats;
mod target_row;
pub mod unfit;
pub mod uv_layer;
pub mod uv_map;

pub(crate) use content::Content;
use number::stored;
pub(crate) use number::{python_float, python_int};
pub(crate) use readers::{Input, Parsed};
#[cfg(test)]
pub(crate) use table::FORMATS;
pub(crate) use table::Needs;
