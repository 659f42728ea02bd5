//! The labels by which assets are chosen: `selection_filter.json`.

pub(in crate::rules) mod conflicting_tags;
pub(in crate::rules) mod dead_entry;
pub(in crate::rules) mod syntax;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&conflicting_tags::RULE, &dead_entry::RULE, &syntax::RULE];
