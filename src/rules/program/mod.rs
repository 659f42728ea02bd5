//! Files of the programs themselves.

pub(in crate::rules) mod file_content;
pub(in crate::rules) mod missing_file;
mod mpfb_content;
mod mpfb_files;
pub(in crate::rules) mod skybox;
