//! Rules on a base mesh, as OBJ or packed.

pub(super) mod degenerate_face;
pub(super) mod face_out_of_range;
pub(super) mod group_name;
pub(super) mod no_faces;
pub(super) mod non_finite;
pub(super) mod partial_uv;
pub(super) mod reopened_group;
pub(super) mod stale_binary;
pub(super) mod syntax;
pub(super) mod unused_vertex;
pub(super) mod vertex_order;
