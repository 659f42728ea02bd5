//! The rules: one a file, one table of them all.
//!
//! A rule reads facts and says what would happen. It reads no files, knows no report and no other rule.

mod archive;
mod base;
mod bvh;
mod catalog;
mod cause;
mod config;
mod file;
mod json;
mod macros;
mod material;
mod mesh;
mod modelling;
mod numeric;
mod overlay;
mod pose;
mod rule;
mod skeleton;
mod target;
mod units;
mod weights;

pub(crate) use rule::{Check, Rule, RuleCx};
use rule::{counted, did_you_mean};

/// Every rule, sorted by id. A rule that is not listed here does not exist.
pub(crate) static RULES: &[&Rule] = &[
    &archive::malformed::RULE,
    &base::barycentric_presets::RULE,
    &base::geometry_range::RULE,
    &base::missing_file::RULE,
    &base::rule_without_effect::RULE,
    &base::unknown_equipment::RULE,
    &base::unknown_preset::RULE,
    &base::unsafe_rule::RULE,
    &base::vertex_count::RULE,
    &config::baseline_stale::RULE,
    &bvh::channels::RULE,
    &bvh::duplicate_joint::RULE,
    &bvh::frames::RULE,
    &bvh::syntax::RULE,
    &catalog::missing_target::RULE,
    &config::expired_ignore::RULE,
    &config::missing_reason::RULE,
    &config::unknown_rule::RULE,
    &config::unused_glob::RULE,
    &config::unused_ignore::RULE,
    &file::absolute_path::RULE,
    &file::backslash_path::RULE,
    &file::byte_order_mark::RULE,
    &file::case_conflict::RULE,
    &file::case_mismatch::RULE,
    &file::decompression_bomb::RULE,
    &file::duplicate_content::RULE,
    &file::empty::RULE,
    &file::gzip_corrupt::RULE,
    &file::in_place_of_folder::RULE,
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
    &material::alternatives_lost::RULE,
    &material::arity::RULE,
    &material::boolean_spelling::RULE,
    &material::coloration_texture::RULE,
    &material::duplicate_keyword::RULE,
    &material::embedding::RULE,
    &material::ignored_key::RULE,
    &material::missing_litsphere::RULE,
    &material::missing_shader::RULE,
    &material::missing_texture::RULE,
    &material::path_quote::RULE,
    &material::range::RULE,
    &material::texture_format::RULE,
    &material::value_type::RULE,
    &material::unknown_keyword::RULE,
    &material::unreadable_texture::RULE,
    &material::unused_texture::RULE,
    &mesh::degenerate_face::RULE,
    &mesh::face_out_of_range::RULE,
    &mesh::group_name::RULE,
    &mesh::no_faces::RULE,
    &mesh::non_finite::RULE,
    &mesh::partial_uv::RULE,
    &mesh::reopened_group::RULE,
    &mesh::stale_binary::RULE,
    &mesh::syntax::RULE,
    &mesh::unused_vertex::RULE,
    &mesh::vertex_order::RULE,
    &modelling::barycentric_arity::RULE,
    &modelling::blank_in_name::RULE,
    &modelling::decr_only::RULE,
    &modelling::default_range::RULE,
    &modelling::display_text::RULE,
    &modelling::duplicate_pattern::RULE,
    &modelling::empty_category::RULE,
    &modelling::macro_without_influence::RULE,
    &modelling::measure::RULE,
    &modelling::missing_icon::RULE,
    &modelling::missing_target::RULE,
    &modelling::no_effect::RULE,
    &modelling::one_sided_symmetry::RULE,
    &modelling::opposites::RULE,
    &modelling::text_slot::RULE,
    &modelling::unknown_group::RULE,
    &modelling::unknown_symmetry::RULE,
    &modelling::unsafe_formula::RULE,
    &modelling::user_key_collision::RULE,
    &modelling::user_pair_at_top::RULE,
    &numeric::collapsed_faces::RULE,
    &numeric::dead_range::RULE,
    &numeric::discontinuity::RULE,
    &numeric::exploded_vertex::RULE,
    &numeric::implausible_size::RULE,
    &numeric::joint_drift::RULE,
    &numeric::non_finite::RULE,
    &numeric::rest_skinning::RULE,
    &numeric::threshold_loss::RULE,
    &numeric::weights_sum::RULE,
    &numeric::zero_length_bone::RULE,
    &overlay::base_folder_missing::RULE,
    &overlay::broken_override::RULE,
    &overlay::empty_target_folder::RULE,
    &overlay::partial_override::RULE,
    &overlay::shadowed::RULE,
    &overlay::targets_not_in_layer::RULE,
    &overlay::user_key_clash::RULE,
    &overlay::user_target_too_deep::RULE,
    &pose::non_finite::RULE,
    &pose::unknown_bone::RULE,
    &skeleton::cycle::RULE,
    &skeleton::degenerate_plane::RULE,
    &skeleton::empty_joint::RULE,
    &skeleton::joint_off_cube::RULE,
    &skeleton::joint_out_of_range::RULE,
    &skeleton::malformed_plane::RULE,
    &skeleton::missing_section::RULE,
    &skeleton::missing_weights::RULE,
    &skeleton::multiple_roots::RULE,
    &skeleton::name_asymmetry::RULE,
    &skeleton::name_clash::RULE,
    &skeleton::no_root::RULE,
    &skeleton::noisy_roll::RULE,
    &skeleton::swapped_ends::RULE,
    &skeleton::unclaimed_bones::RULE,
    &skeleton::unknown_joint::RULE,
    &skeleton::unknown_parent::RULE,
    &skeleton::unknown_plane::RULE,
    &skeleton::unknown_reference::RULE,
    &skeleton::unreachable_bone::RULE,
    &skeleton::unused_joint::RULE,
    &skeleton::unweighted_bone::RULE,
    &skeleton::wrong_side::RULE,
    &skeleton::zero_length_bone::RULE,
    &target::asymmetric::RULE,
    &target::asymmetric_pair::RULE,
    &target::basemesh_mismatch::RULE,
    &target::breaks_start::RULE,
    &target::duplicate_vertex::RULE,
    &target::field_count::RULE,
    &target::missing_opposite::RULE,
    &target::missing_side::RULE,
    &target::moves_helpers_only::RULE,
    &target::negative_index::RULE,
    &target::non_finite::RULE,
    &target::oversized_delta::RULE,
    &target::splits_joint_cube::RULE,
    &target::stale_binary::RULE,
    &target::syntax::RULE,
    &target::unreferenced::RULE,
    &target::vertex_out_of_range::RULE,
    &target::without_effect::RULE,
    &target::zero_delta::RULE,
    &weights::above_one::RULE,
    &weights::asymmetric::RULE,
    &weights::below_threshold::RULE,
    &weights::duplicate_vertex::RULE,
    &weights::empty_bone::RULE,
    &weights::lost_after_threshold::RULE,
    &weights::malformed_pair::RULE,
    &weights::metadata::RULE,
    &weights::negative::RULE,
    &weights::non_finite::RULE,
    &weights::not_normalized::RULE,
    &weights::too_many_influences::RULE,
    &weights::unbound::RULE,
    &weights::unknown_bone::RULE,
    &weights::unweighted_vertex::RULE,
    &weights::vertex_out_of_range::RULE,
    &weights::wrong_side::RULE,
];

/// A share in percent, with a decimal where it is small.
fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

#[cfg(test)]
mod tests {
    use super::RULES;

    #[test]
    fn every_rule_says_what_the_application_does() {
        // Settings of mhlint itself are no application's matter.
        for rule in RULES.iter().filter(|rule| !matches!(rule.info.family(), "config" | "baseline")) {
            let effects = rule.info.breaks;
            assert!(!effects.is_empty(), "{}", rule.info.id);
            assert!(effects.iter().all(|(_, effect)| !effect.trim().is_empty()), "{}", rule.info.id);
        }
    }
}
