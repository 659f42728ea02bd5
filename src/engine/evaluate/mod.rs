//! What `mhlint eval` computes: one base mesh opened from data folders, settings applied by slider name,
//! and the outcomes as plain numbers or JSON.
//!
//! Differs from a lint run in what damage means: here the first fault that stands in the way is an error
//! with name and cause. Writes nothing.
//!
//! ```
//! use std::path::Path;
//! use mhlint::engine::evaluate::Evaluation;
//!
//! let mut evaluation = Evaluation::open(Path::new("fixtures/makehuman2/data"), None, Some("figure"))?;
//! let rest = evaluation.morphed(&evaluation.setting(&[])?)?;
//! let oval = evaluation.setting(&[("head/head-oval".to_owned(), 1.0)])?;
//! let morphed = evaluation.morphed(&oval)?;
//! assert_eq!(rest.len(), morphed.len());
//! assert_ne!(rest, morphed);
//! # Ok::<(), mhlint::engine::evaluate::Error>(())
//! ```

mod asset;
mod cases;
mod error;
mod files;
mod open;
mod outputs;
mod pose;
mod rows;
mod settings;
mod skeleton;
mod weights;

pub use crate::eval::scene::Setting;
pub use crate::eval::vector::Point;
pub use asset::{Asset, Fitted, read_asset};
pub use cases::{CaseReport, CaseRun, Comparison, Deviation, Roots, run_cases};
pub use error::Error;
pub use files::{read_positions, read_text, with_positions};
pub use open::Evaluation;
pub use outputs::{
    fit_json, load_json, macros_json, mesh_json, object, reduction_json, skeleton_json, skin_json, weights_json,
};
pub use pose::{PosedBase, Poses, read_poses};
pub use settings::{parse_setting, read_settings};
pub use skeleton::{RestSkeleton, SkeletonFile, read_skeleton};
pub use weights::{NamedWeights, WeightLists, read_weights, to_mhw, transferred};
