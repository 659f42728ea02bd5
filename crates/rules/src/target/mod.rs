//! Rules on `.target` files and their archives.
//!
//! What more than one of them needs: which files to look at at all, and how rows are named.

use std::collections::BTreeSet;

use super::cause::consequence::{BY_HAND, MACRO_ROWS};
use mhlint_diag::{Case, Element, Place, Tally};
use mhlint_formats::target::TargetFacts;
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{Body, FileFacts, ReferenceKind, Target};

mod asymmetric;
mod asymmetric_pair;
mod basemesh_mismatch;
mod beyond_mesh;
mod beyond_others;
mod breaks_start;
mod custom_name;
mod doubled;
mod duplicate_vertex;
mod endings;
mod field_count;
mod gendered_detail;
mod macro_group;
mod macro_token;
mod meant;
mod missing_combination;
mod missing_opposite;
mod missing_side;
mod moves_helpers_only;
mod negative_index;
mod non_finite;
mod oversized_delta;
mod renumbered;
mod separator;
mod shipped_unused;
mod shown;
mod splits_joint_cube;
mod stale_binary;
mod syntax;
mod token_conflict;
mod unreadable_fields;
mod unreferenced;
mod unused_pairs;
mod user_pairs;
mod vertex_out_of_range;
mod without_effect;
mod without_group;
mod zero_delta;

use super::Rule;
use mhlint_source::parent;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &asymmetric::RULE,
    &asymmetric_pair::RULE,
    &basemesh_mismatch::RULE,
    &breaks_start::RULE,
    &custom_name::RULE,
    &doubled::RULE,
    &duplicate_vertex::RULE,
    &field_count::RULE,
    &gendered_detail::RULE,
    &macro_token::RULE,
    &missing_combination::RULE,
    &missing_opposite::RULE,
    &missing_side::RULE,
    &moves_helpers_only::RULE,
    &negative_index::RULE,
    &non_finite::RULE,
    &oversized_delta::RULE,
    &separator::RULE,
    &splits_joint_cube::RULE,
    &stale_binary::RULE,
    &syntax::RULE,
    &token_conflict::RULE,
    &unreferenced::RULE,
    &vertex_out_of_range::RULE,
    &without_effect::RULE,
    &without_group::RULE,
    &zero_delta::RULE,
];

/// The targets of a body that can be decoded. For others the encoding is the one fault to name. A
/// byte order mark is a fault of the first line only; all are checked as they are without it.
fn targets<'b, 'v>(
    body: &'b Body<'v>,
) -> impl Iterator<Item = (&'b Target<'v>, &'v FileFacts, &'v TargetFacts)> {
    body.targets
        .iter()
        .filter_map(|target| Some((target, target.file, target.file.target()?)))
}

/// What MPFB splits at single blanks, with what becomes of rows at which it stops: of a slider, of
/// the macros, or of a target that is loaded by hand.
fn split_at_blanks<'b, 'v>(
    body: &'b Body<'v>,
) -> impl Iterator<Item = (&'v FileFacts, &'v TargetFacts, Case)> + use<'b, 'v> {
    let case = |used_as| {
        if used_as == Some(ReferenceKind::MacroTarget) {
            MACRO_ROWS
        } else {
            &[]
        }
    };
    let own = targets(body).map(move |(target, file, facts)| (file, facts, case(target.used_as)));
    let of_parts = body
        .part_targets
        .iter()
        .filter_map(|file| Some((*file, file.target()?, BY_HAND)));
    own.chain(of_parts).filter(|_| body.is_mpfb())
}

/// The first row of a tally.
fn first_row(tally: &Tally) -> Place {
    match tally.first.first() {
        Some((line, index)) => u64::try_from(*index).map_or(Place::Line(*line), |index| {
            Place::Row(
                *line,
                Element {
                    kind: "vertex",
                    index,
                },
            )
        }),
        None => Place::File,
    }
}

/// Paths of the targets that something refers to, found or not: where one is missing, that is the
/// fault to name.
fn asked_for<'v>(view: &'v View<'_>, base: &Base<'_>) -> BTreeSet<&'v str> {
    let references = view
        .references_of(base)
        .filter(|reference| reference.kind.is_target());
    references.map(|reference| reference.rel.as_str()).collect()
}
