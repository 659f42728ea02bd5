//! Rules on `.mhw`, and what they share: which files count, and where a pair stands.

pub(super) mod above_one;
pub(super) mod asymmetric;
pub(super) mod below_threshold;
pub(super) mod duplicate_vertex;
pub(super) mod empty_bone;
mod loss;
pub(super) mod lost_after_threshold;
pub(super) mod malformed_pair;
pub(super) mod metadata;
pub(super) mod negative;
pub(super) mod non_finite;
pub(super) mod not_normalized;
pub(super) mod too_many_influences;
pub(super) mod unbound;
pub(super) mod unknown_bone;
pub(super) mod unweighted_vertex;
pub(super) mod vertex_out_of_range;
pub(super) mod wrong_side;

use super::cause::weights::{has_unusable_entries, unusable_entries};
use crate::diag::{Cases, Place};
use crate::formats::mhw::{PairTally, Weights};
use crate::repo::FileFacts;

/// The weights in a file, if they are an object of bones.
fn bones_of(file: &FileFacts) -> Option<&Weights> {
    file.weights().filter(|weights| weights.has_weights)
}

/// Whether no bone has a single entry.
fn is_empty(weights: &Weights) -> bool {
    weights.bones.iter().all(|bone| bone.is_list && bone.listed == 0)
}

/// The first pair of a tally.
fn pair_place(tally: &PairTally) -> Option<Place> {
    let (bone, position, ..) = tally.first.first()?;
    Some(Place::pointer(["weights", bone, &position.to_string()]))
}

/// Adds the largest number of a tally.
fn worst(evidence: Cases, tally: &PairTally) -> Cases {
    match &tally.worst {
        Some((bone, vertex, weight)) => evidence.with_worst(f64::from(*weight), format!("{bone}[{vertex}]")),
        None => evidence,
    }
}
