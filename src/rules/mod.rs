//! Judgement: one rule a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod archive;
mod file;
mod json;
mod macros;
mod overlay;
mod rule;
mod target;

pub(crate) use rule::{Check, Rule, RuleCx};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &archive::malformed::RULE,
    &file::absolute_path::RULE,
    &file::backslash_path::RULE,
    &file::byte_order_mark::RULE,
    &file::case_conflict::RULE,
    &file::case_mismatch::RULE,
    &file::decompression_bomb::RULE,
    &file::duplicate_content::RULE,
    &file::empty::RULE,
    &file::gzip_corrupt::RULE,
    &file::lfs_pointer::RULE,
    &file::link_loop::RULE,
    &file::not_utf8::RULE,
    &file::path_escape::RULE,
    &file::too_large::RULE,
    &file::unportable_name::RULE,
    &file::unreadable::RULE,
    &file::unreferenced::RULE,
    &json::duplicate_key::RULE,
    &json::schema::RULE,
    &json::syntax::RULE,
    &json::too_deep::RULE,
    &json::unknown_key::RULE,
    &macros::alias_suspect::RULE,
    &macros::ambiguous_value::RULE,
    &macros::barycentric_mismatch::RULE,
    &macros::duplicate_combination::RULE,
    &macros::duplicate_value::RULE,
    &macros::empty_target::RULE,
    &macros::folder_missing::RULE,
    &macros::influence_mismatch::RULE,
    &macros::influence_range::RULE,
    &macros::missing_combination::RULE,
    &macros::missing_target::RULE,
    &macros::name_collision::RULE,
    &macros::repeated_component::RULE,
    &macros::steps_and_sum::RULE,
    &macros::steps_length::RULE,
    &macros::steps_order::RULE,
    &macros::steps_range::RULE,
    &macros::sum_arity::RULE,
    &macros::target_extension::RULE,
    &macros::too_many_active::RULE,
    &macros::unexpected_combination::RULE,
    &macros::unknown_component::RULE,
    &macros::unknown_pattern::RULE,
    &macros::unreferenced_target::RULE,
    &macros::unused_component::RULE,
    &overlay::broken_override::RULE,
    &overlay::needs_system::RULE,
    &overlay::partial_override::RULE,
    &overlay::shadowed::RULE,
    &overlay::targets_not_in_layer::RULE,
    &overlay::user_key_clash::RULE,
    &overlay::user_target_too_deep::RULE,
    &target::basemesh_mismatch::RULE,
    &target::breaks_start::RULE,
    &target::duplicate_vertex::RULE,
    &target::field_count::RULE,
    &target::missing_opposite::RULE,
    &target::missing_side::RULE,
    &target::negative_index::RULE,
    &target::non_finite::RULE,
    &target::oversized_delta::RULE,
    &target::stale_binary::RULE,
    &target::syntax::RULE,
    &target::unreferenced::RULE,
    &target::vertex_out_of_range::RULE,
    &target::without_effect::RULE,
    &target::zero_delta::RULE,
];
