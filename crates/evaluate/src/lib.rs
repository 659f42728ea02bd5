//! What is computed of the files of a base: its measures for rules, and what `mhlint eval` shows.
//!
//! For rules the shape of a base is taken as far as its files can be used. `mhlint eval` works on
//! one base opened from data folders (`open_base` of the engine), with settings by slider name and
//! outcomes as plain numbers or JSON; there the first fault that stands in the way is an error with
//! name and cause. Writes nothing, and is handed what it works on: it looks for no folders.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod asset_file;
mod cases;
mod data;
mod error;
mod files;
mod formulas;
mod gauge;
pub mod makehuman1;
pub mod makehuman2;
pub mod mpfb;
mod opened;
mod outputs;
mod pose;
mod rows;
mod settings;
mod worn;

pub use cases::{CaseReport, CaseRun, Comparison, Deviation, OpenBase, Roots, run_cases};
pub use data::{Fitted, NamedWeights, RestSkeleton, SkeletonFile};
pub use error::Error;
pub use files::{read_positions, read_text, with_positions};
pub use mhlint_eval::scene::Setting;
pub use mhlint_eval::settings::SliderSetting;
pub use mhlint_eval::vector::Point;
pub use opened::Evaluation;
pub use outputs::{
    fit_json, load_json, mesh_json, object, reduction_json, skeleton_json, skin_json, weights_json,
};
pub use pose::{PosedBase, Poses, read_poses};
pub use settings::{parse_setting, read_settings};

pub use formulas::{Openable, measure, openable};

use std::collections::BTreeMap;
use std::sync::Arc;

use mhlint_formats::target::Row;

/// Rows of targets by printed path.
pub type Rows = BTreeMap<String, Arc<Vec<Row>>>;
