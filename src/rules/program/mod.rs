//! Files of MakeHuman 2 itself.

pub(in crate::rules) mod file_content;
pub(in crate::rules) mod missing_file;
pub(in crate::rules) mod skybox;
