//! Rules on `.mhw`, and what they share: which files count, and where a pair stands.

mod above_one;
mod asymmetric;
mod below_threshold;
mod duplicate_vertex;
mod empty_bone;
mod loss;
mod lost_after_threshold;
mod malformed_pair;
mod metadata;
mod negative;
mod non_finite;
mod not_normalized;
mod places;
mod too_many_influences;
mod unbound;
mod unknown_bone;
mod unweighted_vertex;
mod vertex_out_of_range;
mod wrong_side;

use super::Rule;
use super::cause::weights::{has_unusable_entries, unusable_entries};
use super::units::short;
use mhlint_diag::{Application::Makehuman2, Case, Cases, Finding, Level, Place};
use mhlint_formats::mhw::{PairTally, Weights, WeightsFacts};
use mhlint_repo::{Body, BodyWeights, WeightsUse};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &above_one::RULE,
    &asymmetric::RULE,
    &below_threshold::RULE,
    &duplicate_vertex::RULE,
    &empty_bone::RULE,
    &lost_after_threshold::RULE,
    &malformed_pair::RULE,
    &metadata::RULE,
    &negative::RULE,
    &non_finite::RULE,
    &not_normalized::RULE,
    &too_many_influences::RULE,
    &unbound::RULE,
    &unknown_bone::RULE,
    &unweighted_vertex::RULE,
    &vertex_out_of_range::RULE,
    &wrong_side::RULE,
];

/// The weights of a body, and of what it wears, that are read and are an object of bones.
fn readable<'b, 'v>(
    body: &'b Body<'v>,
) -> impl Iterator<Item = (&'b BodyWeights<'v>, &'v Weights)> {
    let read = body
        .weights
        .iter()
        .filter(|own| own.used != WeightsUse::Unread);
    read.filter_map(|own| {
        Some((
            own,
            own.file.weights().filter(|weights| weights.has_weights)?,
        ))
    })
}

/// Those for the mesh of the body itself.
fn readable_own<'b, 'v>(
    body: &'b Body<'v>,
) -> impl Iterator<Item = (&'b BodyWeights<'v>, &'v Weights)> {
    readable(body).filter(|(own, _)| own.name.is_some())
}

/// A vertex of weights in words, with its place where it is one of the body.
fn vertex_of(body: &Body<'_>, own: &BodyWeights<'_>, vertex: i64) -> String {
    if own.name.is_some() {
        body.vertex(vertex)
    } else {
        format!("vertex {vertex}")
    }
}

/// A finding on what moves with the weights, of some that are loaded and move nothing.
fn weigh(own: &BodyWeights<'_>, finding: Finding) -> Finding {
    if own.used == WeightsUse::Loaded {
        finding.case(NEVER_APPLIED)
    } else {
        finding
    }
}

const NEVER_APPLIED: Case = &[(
    Makehuman2,
    Level::Info,
    "never applies these weights: another skeleton poses the base",
)];

/// Whether no bone has a single entry.
fn is_empty(weights: &Weights) -> bool {
    weights
        .bones
        .iter()
        .all(|bone| bone.is_list && bone.listed == 0)
}

/// Pairs of weights with one fault, and the first of them.
struct Tallied<'b, 'v> {
    own: &'b BodyWeights<'v>,
    weights: &'v Weights,
    tally: &'v PairTally,
    bone: &'v str,
    /// The first vertex, in words.
    vertex: String,
    weight: f32,
    place: Place,
}

/// The readable weights of a body in which some pair was counted.
fn tallied<'b, 'v>(
    body: &'b Body<'v>,
    tally: fn(&WeightsFacts) -> &PairTally,
) -> impl Iterator<Item = Tallied<'b, 'v>> {
    readable(body).filter_map(move |(own, weights)| {
        let tally = tally(&weights.facts);
        let (bone, position, vertex, weight) = tally.first.first()?;
        let place = Place::pointer(["weights", bone, &position.to_string()]);
        Some(Tallied {
            own,
            weights,
            tally,
            bone,
            vertex: vertex_of(body, own, *vertex),
            weight: *weight,
            place,
        })
    })
}

/// Adds the largest number of a tally.
fn worst(evidence: Cases, tally: &PairTally) -> Cases {
    match &tally.worst {
        Some((bone, vertex, weight)) => {
            evidence.with_worst(f64::from(*weight), format!("{bone}[{vertex}]"))
        }
        None => evidence,
    }
}

/// `, at worst 8.2`, where that is another one than the first.
fn at_worst(tally: &PairTally, first: f32) -> String {
    let worst = tally
        .worst
        .as_ref()
        .filter(|(_, _, worst)| worst.total_cmp(&first).is_ne());
    worst.map_or_else(String::new, |(_, _, worst)| {
        format!(", at worst {}", short(f64::from(*worst)))
    })
}
