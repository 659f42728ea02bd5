//! Materials: `.mhmat`.

mod advice;
pub(in crate::rules) mod alias_in_file_name;
pub(in crate::rules) mod alternatives_lost;
mod alternatives_shared;
pub(in crate::rules) mod arity;
mod blender;
pub(in crate::rules) mod boolean_spelling;
pub(in crate::rules) mod coloration_texture;
pub(in crate::rules) mod colour_space;
pub(in crate::rules) mod conflicting_maps;
pub(in crate::rules) mod duplicate_keyword;
pub(in crate::rules) mod embedding;
mod fault;
pub(in crate::rules) mod ignored_key;
mod loader;
pub(in crate::rules) mod missing_litsphere;
pub(in crate::rules) mod missing_shader;
pub(in crate::rules) mod missing_texture;
pub(in crate::rules) mod missing_uvmap;
pub(in crate::rules) mod opacity;
mod others;
pub(in crate::rules) mod path_quote;
mod picture;
pub(in crate::rules) mod plain_colour;
pub(in crate::rules) mod protected_name;
pub(in crate::rules) mod range;
pub(in crate::rules) mod skin_without_texture;
mod something_else;
mod spelling;
pub(in crate::rules) mod texture_format;
pub(in crate::rules) mod texture_name_clash;
pub(in crate::rules) mod tinted_texture;
pub(in crate::rules) mod uniform_type;
pub(in crate::rules) mod unknown_define;
pub(in crate::rules) mod unknown_keyword;
pub(in crate::rules) mod unknown_uniform;
pub(in crate::rules) mod unreadable_texture;
pub(in crate::rules) mod unused_texture;
pub(in crate::rules) mod uvmap_mismatch;
pub(in crate::rules) mod value_type;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &alternatives_lost::RULE,
    &arity::RULE,
    &boolean_spelling::RULE,
    &coloration_texture::RULE,
    &colour_space::RULE,
    &duplicate_keyword::RULE,
    &embedding::RULE,
    &ignored_key::RULE,
    &missing_litsphere::RULE,
    &missing_shader::RULE,
    &missing_texture::RULE,
    &missing_uvmap::RULE,
    &opacity::RULE,
    &path_quote::RULE,
    &protected_name::RULE,
    &range::RULE,
    &texture_format::RULE,
    &tinted_texture::RULE,
    &value_type::RULE,
    &uniform_type::RULE,
    &unknown_define::RULE,
    &unknown_keyword::RULE,
    &unknown_uniform::RULE,
    &unreadable_texture::RULE,
    &unused_texture::RULE,
    &uvmap_mismatch::RULE,
    &alias_in_file_name::RULE,
    &conflicting_maps::RULE,
    &plain_colour::RULE,
    &skin_without_texture::RULE,
    &texture_name_clash::RULE,
];
