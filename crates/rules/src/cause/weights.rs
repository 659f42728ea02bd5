//! Weights with entries that are lost: what is missing or off beside them may be their doing.

use mhlint_formats::mhw::Weights;

/// Whether entries cannot be used, so that what is missing or off beside them may be their doing.
///
/// Such entries have findings of their own: malformed, out of range, not finite, or against the
/// schema. What else is wrong in the file (its metadata, say) does not matter.
pub(crate) fn has_unusable_entries(weights: &Weights) -> bool {
    unusable_entries(weights).is_none_or(|count| count > 0)
}

/// How many entries cannot be used; `None` if nobody can tell.
pub(crate) fn unusable_entries(weights: &Weights) -> Option<u64> {
    let facts = &weights.facts;
    let countable = weights.has_weights && !weights.has_shapeless_bone;
    countable.then_some(facts.malformed.count + facts.out_of_range.count + facts.non_finite.count)
}
