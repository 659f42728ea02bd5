//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod macros;
mod mesh;
mod rule;
mod skeleton;
mod target;
mod weights;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &macros::steps_length::RULE,
    &mesh::face_out_of_range::RULE,
    &mesh::group_name::RULE,
    &mesh::non_finite::RULE,
    &mesh::partial_uv::RULE,
    &mesh::reopened_group::RULE,
    &mesh::syntax::RULE,
    &mesh::unused_vertex::RULE,
    &skeleton::cycle::RULE,
    &skeleton::empty_joint::RULE,
    &skeleton::joint_out_of_range::RULE,
    &skeleton::malformed_plane::RULE,
    &skeleton::missing_section::RULE,
    &skeleton::missing_weights::RULE,
    &skeleton::multiple_roots::RULE,
    &skeleton::name_asymmetry::RULE,
    &skeleton::no_root::RULE,
    &skeleton::unknown_joint::RULE,
    &skeleton::unknown_parent::RULE,
    &skeleton::unknown_plane::RULE,
    &skeleton::unknown_reference::RULE,
    &skeleton::unreachable_bone::RULE,
    &skeleton::unused_joint::RULE,
    &target::syntax::RULE,
    &weights::above_one::RULE,
    &weights::below_threshold::RULE,
    &weights::duplicate_vertex::RULE,
    &weights::empty_bone::RULE,
    &weights::malformed_pair::RULE,
    &weights::metadata::RULE,
    &weights::negative::RULE,
    &weights::non_finite::RULE,
    &weights::not_normalized::RULE,
    &weights::unbound::RULE,
    &weights::unknown_bone::RULE,
    &weights::unweighted_vertex::RULE,
    &weights::vertex_out_of_range::RULE,
];
