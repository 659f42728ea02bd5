//! Rules on the OBJ of a base mesh.

pub(super) mod face_out_of_range;
pub(super) mod group_name;
pub(super) mod non_finite;
pub(super) mod partial_uv;
pub(super) mod reopened_group;
pub(super) mod syntax;
pub(super) mod unused_vertex;

use crate::formats::obj::Mesh;
use crate::repo::{FileFacts, Layer};

/// All base meshes of a layer.
fn meshes(layer: &Layer) -> impl Iterator<Item = (&FileFacts, &Mesh)> {
    layer.files.values().filter_map(|file| Some((file, file.mesh()?)))
}
