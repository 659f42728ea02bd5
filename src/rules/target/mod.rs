//! Rules on `.target` files and their archives.
//!
//! What more than one of them needs: which files to look at at all, and how rows are named.

use std::collections::BTreeSet;

use super::cause::consequence::{BY_HAND, MACRO_ROWS};
use crate::diag::{Case, Element, Place, Tally};
use crate::formats::target::TargetFacts;
use crate::repo::makehuman2::{Base, View};
use crate::repo::{Body, FileFacts, ReferenceKind, Target, parent};

pub(super) mod asymmetric;
pub(super) mod asymmetric_pair;
pub(super) mod basemesh_mismatch;
mod beyond_mesh;
mod beyond_others;
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
mod renumbered;
pub(super) mod separator;
mod shown;
pub(super) mod splits_joint_cube;
pub(super) mod stale_binary;
pub(super) mod syntax;
pub(super) mod token_conflict;
mod unreadable_fields;
pub(super) mod unreferenced;
mod user_pairs;
pub(super) mod vertex_out_of_range;
pub(super) mod without_effect;
pub(super) mod zero_delta;

/// The targets of a body that can be decoded. For others the encoding is the one fault to name. A byte order mark is a
/// fault of the first line only; all are checked as they are without it.
fn targets<'b, 'v>(body: &'b Body<'v>) -> impl Iterator<Item = (&'b Target<'v>, &'v FileFacts, &'v TargetFacts)> {
    body.targets.iter().filter_map(|target| Some((target, target.file, target.file.target()?)))
}

/// What MPFB splits at single blanks, with what becomes of rows at which it stops: of a slider, of the macros, or of a
/// target that is loaded by hand.
fn split_at_blanks<'b, 'v>(
    body: &'b Body<'v>,
) -> impl Iterator<Item = (&'v FileFacts, &'v TargetFacts, Case)> + use<'b, 'v> {
    let case = |used_as| if used_as == Some(ReferenceKind::MacroTarget) { MACRO_ROWS } else { &[] };
    let own = targets(body).map(move |(target, file, facts)| (file, facts, case(target.used_as)));
    let of_parts = body.part_targets.iter().filter_map(|file| Some((*file, file.target()?, BY_HAND)));
    own.chain(of_parts).filter(|_| body.is_mpfb())
}

/// The first row of a tally.
fn first_row(tally: &Tally) -> Place {
    match tally.first.first() {
        Some((line, index)) => u64::try_from(*index)
            .map_or(Place::Line(*line), |index| Place::Row(*line, Element { kind: "vertex", index })),
        None => Place::File,
    }
}

/// Paths of the targets that something refers to, found or not: where one is missing, that is the fault to name.
fn asked_for<'v>(view: &'v View<'_>, base: &Base<'_>) -> BTreeSet<&'v str> {
    let references = view.references_of(base).filter(|reference| reference.kind.is_target());
    references.map(|reference| reference.rel.as_str()).collect()
}
