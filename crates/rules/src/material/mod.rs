//! Materials: `.mhmat`.

mod advice;
pub(crate) mod alias_in_file_name;
mod alternatives_around;
pub(crate) mod alternatives_lost;
mod alternatives_shared;
pub(crate) mod arity;
mod beside;
mod blender;
pub(crate) mod boolean_spelling;
pub(crate) mod coloration_texture;
pub(crate) mod colour_space;
pub(crate) mod conflicting_maps;
pub(crate) mod duplicate_keyword;
pub(crate) mod embedding;
mod fault;
mod faulty_lines;
pub(crate) mod ignored_key;
mod loader;
pub(crate) mod missing_litsphere;
pub(crate) mod missing_shader;
pub(crate) mod missing_texture;
pub(crate) mod missing_uvmap;
pub(crate) mod opacity;
mod others;
pub(crate) mod path_quote;
mod picture;
pub(crate) mod plain_colour;
pub(crate) mod protected_name;
pub(crate) mod range;
pub(crate) mod skin_without_texture;
mod something_else;
mod spelling;
pub(crate) mod texture_format;
pub(crate) mod texture_name_clash;
pub(crate) mod tinted_texture;
pub(crate) mod uniform_type;
pub(crate) mod unknown_define;
pub(crate) mod unknown_keyword;
pub(crate) mod unknown_uniform;
pub(crate) mod unreadable_texture;
pub(crate) mod unused_texture;
pub(crate) mod uvmap_mismatch;
pub(crate) mod value_type;

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
