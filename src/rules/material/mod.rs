//! Materials: `.mhmat`.

mod advice;
pub(in crate::rules) mod alternatives_lost;
pub(in crate::rules) mod arity;
pub(in crate::rules) mod boolean_spelling;
pub(in crate::rules) mod coloration_texture;
pub(in crate::rules) mod duplicate_keyword;
pub(in crate::rules) mod embedding;
mod fault;
pub(in crate::rules) mod ignored_key;
mod loader;
pub(in crate::rules) mod missing_litsphere;
pub(in crate::rules) mod missing_shader;
pub(in crate::rules) mod missing_texture;
pub(in crate::rules) mod missing_uvmap;
pub(in crate::rules) mod path_quote;
mod picture;
pub(in crate::rules) mod protected_name;
pub(in crate::rules) mod range;
pub(in crate::rules) mod texture_format;
pub(in crate::rules) mod uniform_type;
pub(in crate::rules) mod unknown_define;
pub(in crate::rules) mod unknown_keyword;
pub(in crate::rules) mod unknown_uniform;
pub(in crate::rules) mod unreadable_texture;
pub(in crate::rules) mod unused_texture;
pub(in crate::rules) mod uvmap_mismatch;
pub(in crate::rules) mod value_type;
