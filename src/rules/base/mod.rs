//! Rules on `base.json` and `geometry.json` of a base mesh of MakeHuman 2.

mod absent_keys;
pub(super) mod barycentric_presets;
pub(super) mod geometry_range;
pub(super) mod missing_file;
mod names;
mod other_base;
pub(super) mod rule_without_effect;
mod sliders;
pub(super) mod unknown_equipment;
pub(super) mod unknown_preset;
pub(super) mod unsafe_rule;
pub(super) mod vertex_count;

/// The way to leave a measure out.
const NO_MEASURE: &str = "none";
