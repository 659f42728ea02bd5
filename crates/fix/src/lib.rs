//! Edits to bytes to disk: what is asked for is planned, applied, shown as a difference, or
//! written.
//!
//! Knows neither formats nor rules: it gets byte ranges. A file is replaced as a whole or left
//! alone.

// Only a few modules may use files, streams and the environment, and they allow this lint
// themselves; tests may use everything.
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]
#![expect(clippy::disallowed_methods, reason = "the only writer of assets")]

mod beside;
mod diff;
mod journal;
mod packed;
mod pending;
mod plan;
mod write;

pub use beside::replace;
pub use diff::unified;
pub use journal::Left;
pub use packed::{is_packed, pack, unpack};
pub use pending::Pending;
pub use plan::{Patch, Plan, apply};
pub use write::{FileChange, WriteError, write_all};
