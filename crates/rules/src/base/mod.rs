//! Rules on `base.json` and `geometry.json` of a base mesh of MakeHuman 2.

mod absent_keys;
mod barycentric_presets;
mod geometry_range;
mod missing_file;
mod names;
mod orphan;
mod other_base;
mod rule_without_effect;
mod sliders;
mod unknown_equipment;
mod unknown_preset;
mod unsafe_rule;
mod vertex_count;
mod visible_text;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &barycentric_presets::RULE,
    &geometry_range::RULE,
    &missing_file::RULE,
    &rule_without_effect::RULE,
    &unknown_equipment::RULE,
    &unknown_preset::RULE,
    &unsafe_rule::RULE,
    &vertex_count::RULE,
];

/// The way to leave a measure out.
const NO_MEASURE: &str = "none";
