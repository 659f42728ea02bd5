//! The labels by which assets are chosen: `selection_filter.json`.

pub(crate) mod conflicting_tags;
pub(crate) mod dead_entry;
pub(crate) mod syntax;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&conflicting_tags::RULE, &dead_entry::RULE, &syntax::RULE];
