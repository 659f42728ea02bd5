//! What is computed of the files of a base: its measures for rules, and what `mhlint eval` shows.
//!
//! For rules the shape of a base is taken as far as its files can be used. `mhlint eval` works on one base opened
//! from data folders ([`open_base`](crate::open_base)), with settings by slider name and outcomes as plain numbers or
//! JSON; there the first fault that stands in the way is an error with name and cause. Writes nothing, and is
//! handed what it works on: it looks for no folders.
//!
//! ```
//! use std::path::Path;
//! let mut evaluation = mhlint::open_base(Path::new("fixtures/makehuman2/data"), None, Some("figure"))?;
//! let rest = evaluation.morphed(&evaluation.setting(&[])?)?;
//! let oval = evaluation.setting(&[("head/head-oval".to_owned(), 1.0)])?;
//! let morphed = evaluation.morphed(&oval)?;
//! assert_eq!(rest.len(), morphed.len());
//! assert_ne!(rest, morphed);
//! # Ok::<(), mhlint::evaluate::Error>(())
//! ```

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

pub use crate::eval::scene::Setting;
pub use crate::eval::settings::SliderSetting;
pub use crate::eval::vector::Point;
pub use cases::{CaseReport, CaseRun, Comparison, Deviation, OpenBase, Roots, run_cases};
pub use data::{Fitted, NamedWeights, RestSkeleton, SkeletonFile};
pub use error::Error;
pub use files::{read_positions, read_text, with_positions};
pub use opened::Evaluation;
pub use outputs::{fit_json, load_json, mesh_json, object, reduction_json, skeleton_json, skin_json, weights_json};
pub use pose::{PosedBase, Poses, read_poses};
pub use settings::{parse_setting, read_settings};

pub(crate) use formulas::{Openable, evaluated, is_measured, measure, needs_rows, openable};

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::formats::target::Row;

/// Rows of targets by printed path.
pub(crate) type Rows = BTreeMap<String, Arc<Vec<Row>>>;
