//! Files of the programs themselves.

pub(in crate::rules) mod file_content;
mod later;
mod makehuman1_files;
mod makehuman2_files;
pub(in crate::rules) mod missing_file;
mod mpfb_content;
mod mpfb_files;
pub(in crate::rules) mod older_version;
pub(in crate::rules) mod partial_copy;
mod randomization;
mod restoring;
mod sky_sides;
pub(in crate::rules) mod skybox;
mod version_keys;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] =
    &[&file_content::RULE, &missing_file::RULE, &older_version::RULE, &partial_copy::RULE, &skybox::RULE];
