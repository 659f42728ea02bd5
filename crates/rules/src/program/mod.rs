//! Files of the programs themselves.

pub(crate) mod file_content;
mod later;
mod makehuman1_files;
mod makehuman2_files;
pub(crate) mod missing_file;
mod mpfb_content;
mod mpfb_files;
pub(crate) mod older_version;
pub(crate) mod partial_copy;
mod randomization;
mod restoring;
mod sky_sides;
pub(crate) mod skybox;
mod version_keys;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &file_content::RULE,
    &missing_file::RULE,
    &older_version::RULE,
    &partial_copy::RULE,
    &skybox::RULE,
];
