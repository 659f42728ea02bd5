//! What other rules keep quiet for, because a finding already names the cause; and what a damaged
//! file leads to.
//!
//! Predicates are named after facts, not after rules. What only one rule asks stands in its file.

pub(super) mod archived;
pub(crate) mod bytes_by_version;
mod capitals;
pub(super) mod component;
pub(super) mod consequence;
pub(super) mod copies;
mod file;
mod generated;
pub(super) mod groups;
pub(super) mod library;
pub(super) mod mesh;
pub(super) mod outdated;
pub(super) mod overlay;
pub(super) mod schema;
pub(super) mod unfiled;
pub(super) mod unmerged;
pub(super) mod weights;
pub(super) mod worn;

pub(super) use capitals::differing;
pub(super) use file::{counts_as_missing, is_ignored_override, is_override, is_unmet};
pub(super) use generated::is_generated_for;
