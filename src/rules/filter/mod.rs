//! The labels by which assets are chosen: `selection_filter.json`.

pub(in crate::rules) mod conflicting_tags;
pub(in crate::rules) mod dead_entry;
pub(in crate::rules) mod syntax;
