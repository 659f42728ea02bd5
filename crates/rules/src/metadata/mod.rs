//! Rules on what MPFB knows of its base mesh besides the OBJ.

pub(crate) mod base_mesh;
mod corrections;
mod faces;
mod mirror;
mod size;
pub(crate) mod table;
mod vertex_groups;

use super::Rule;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[&base_mesh::RULE, &table::RULE];
