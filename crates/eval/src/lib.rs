//! The numbers that exist only once several files meet: macro factors, morphed meshes, joints, rest
//! matrices, weights, fitted assets.
//!
//! Gets plain slices, returns plain numbers; imports nothing but `std`. No paths, no file formats,
//! no diagnostics, no I/O. Points and deltas are `[f32; 3]` in mesh units (one unit is one
//! decimetre), as the applications store them; sums and matrices are `f64`. Matrices are rows,
//! points are columns. Data that would stop the application is an `Err`; data that the application
//! skips is skipped, and the function says so. Non-finite numbers pass through: what the
//! application would turn into NaN is NaN here.
//!
//! What applications calculate alike, and what is measured on it, is here; where they differ, each
//! has a folder with its formulas (`makehuman1`, `makehuman2`, `mpfb`).
//!
//! ```
//! use mhlint_eval::makehuman2::joints::joint_position;
//! use mhlint_eval::morph::apply;
//!
//! let mut mesh = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
//! let target = [(1, [0.0, 1.0, 0.0])];
//! apply(&mut mesh, target.into_iter(), 0.5)?;
//! assert_eq!(mesh, [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0]]);
//! assert_eq!(joint_position(&mesh, &[0, 1])?, [1.0, 0.25, 0.0]);
//! # Ok::<(), mhlint_eval::error::EvalError>(())
//! ```

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![cfg_attr(
    test,
    allow(
        clippy::float_cmp,
        clippy::panic,
        clippy::unwrap_used,
        reason = "tests choose numbers without rounding and may stop"
    )
)]

mod attachment;
pub mod culprit;
pub mod error;
pub mod faces;
pub mod fit;
mod grid;
pub mod influences;
mod lists;
pub mod load;
pub mod look;
pub mod macros;
pub mod makehuman1;
pub mod makehuman2;
pub mod measure;
pub mod measures;
pub mod mesh;
pub mod morph;
pub mod mpfb;
mod nearest;
pub mod proportion;
pub mod rig_measure;
pub mod scene;
pub mod settings;
pub mod side;
pub mod skeleton;
pub mod skin;
pub mod steps;
pub mod survey;
pub mod surveyor;
pub mod symmetry;
pub mod target_measure;
pub mod tears;
pub mod vector;
pub mod walk;
pub mod weights;
pub mod worn;
