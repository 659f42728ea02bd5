//! Rules on what MPFB knows of its base mesh besides the OBJ.

pub(in crate::rules) mod base_mesh;
mod corrections;
mod faces;
mod mirror;
mod size;
pub(in crate::rules) mod table;
mod vertex_groups;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&base_mesh::RULE, &table::RULE];
