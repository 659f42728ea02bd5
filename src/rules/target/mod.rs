//! Rules on `.target` files and their archives.
//!
//! What more than one of them needs: which files to look at at all, and how rows are named.

use super::cause::archived;
use super::cause::archived::{is_archived, target_folder};
use super::cause::usage::{self, parent};
use crate::diag::{Element, Place, Tally};
use crate::formats::target::TargetFacts;
use crate::repo::{FileFacts, Layer};

pub(super) mod asymmetric;
pub(super) mod asymmetric_pair;
pub(super) mod basemesh_mismatch;
pub(super) mod breaks_start;
pub(super) mod duplicate_vertex;
pub(super) mod field_count;
mod meant;
pub(super) mod missing_opposite;
pub(super) mod missing_side;
pub(super) mod moves_helpers_only;
pub(super) mod negative_index;
pub(super) mod non_finite;
pub(super) mod oversized_delta;
mod shown;
pub(super) mod splits_joint_cube;
pub(super) mod stale_binary;
pub(super) mod syntax;
mod unreadable_fields;
pub(super) mod unreferenced;
pub(super) mod vertex_out_of_range;
pub(super) mod without_effect;
pub(super) mod zero_delta;

/// Targets of a layer that the loader can decode.
fn targets(layer: &Layer) -> impl Iterator<Item = (&FileFacts, &TargetFacts)> {
    layer.files.values().filter_map(decoded)
}

/// Facts of a target that the loader can decode. For others the encoding is the one fault to name. A byte order mark
/// is a fault of the first line only; all are judged as they are without it.
fn decoded(file: &FileFacts) -> Option<(&FileFacts, &TargetFacts)> {
    file.target().map(|facts| (file, facts))
}

/// The first row of a tally.
fn first_row(tally: &Tally) -> Place {
    match tally.first.first() {
        Some((line, index)) => u64::try_from(*index)
            .map_or(Place::Line(*line), |index| Place::Row(*line, Element { kind: "vertex", index })),
        None => Place::File,
    }
}

/// `1 row`, `3 rows`.
fn counted(count: u64, thing: &str) -> String {
    if count == 1 { format!("1 {thing}") } else { format!("{count} {thing}s") }
}
