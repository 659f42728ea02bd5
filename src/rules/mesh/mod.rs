//! Rules on meshes: of a base, as OBJ or packed, and of assets.

pub(super) mod degenerate_face;
pub(super) mod duplicate_face;
pub(super) mod face_out_of_range;
pub(super) mod group_name;
pub(super) mod inside_out;
pub(super) mod missing_groups;
pub(super) mod name_clash;
pub(super) mod ngon;
pub(super) mod no_faces;
pub(super) mod no_uv;
pub(super) mod non_finite;
pub(super) mod not_manifold;
pub(super) mod partial_uv;
pub(super) mod pole;
pub(super) mod reopened_group;
pub(super) mod stale_binary;
pub(super) mod syntax;
pub(super) mod unused_vertex;
pub(super) mod vertex_order;

use super::cause::mesh::weigh;
use super::proxy::{STOPS_WITH_INDEX, STOPS_WITH_OVERFLOW};
use crate::diag::{Application::Makehuman2, Case, Finding, Level};
use crate::formats::asset_mesh::AssetMesh;
use crate::formats::obj::MeshFacts;
use crate::repo::{FileFacts, ReferenceKind, View};

/// A mesh that is read: of a base, or of an asset.
#[derive(Clone, Copy)]
struct ReadMesh<'f> {
    facts: &'f MeshFacts,
    /// Faces that could be read.
    faces: usize,
    uvs: usize,
    asset: Option<&'f AssetMesh>,
}

/// What is read of a file, if it is a mesh that is read.
fn read<'f>(view: &View<'_>, file: &'f FileFacts) -> Option<ReadMesh<'f>> {
    if let Some(mesh) = file.mesh() {
        return Some(ReadMesh { facts: &mesh.facts, faces: mesh.faces.len(), uvs: mesh.uvs.len(), asset: None });
    }
    let asset = of_asset(view, file)?;
    Some(ReadMesh { facts: &asset.facts, faces: asset.faces, uvs: asset.uvs, asset: Some(asset) })
}

/// The mesh of an asset, if some asset names it.
fn of_asset<'f>(view: &View<'_>, file: &'f FileFacts) -> Option<&'f AssetMesh> {
    let is_named = |_: &&AssetMesh| view.references().to_file(file).any(|one| one.kind == ReferenceKind::AssetMesh);
    file.asset_mesh().filter(|_| file.encoding.invalid_utf8_at.is_none()).filter(is_named)
}

impl ReadMesh<'_> {
    /// A finding with the consequence for the sort of mesh.
    fn weigh(&self, view: &View<'_>, file: &FileFacts, finding: Finding, of_asset: Case) -> Finding {
        if self.asset.is_some() { finding.case(of_asset) } else { weigh(view, file, finding) }
    }

    /// A vertex with its group.
    fn named(&self, view: &View<'_>, file: &FileFacts, vertex: i64) -> String {
        let of_base = || view.landmarks(file).map(|body| body.vertex(vertex));
        let named = self.asset.map(|asset| asset.named(vertex)).or_else(of_base);
        named.unwrap_or_else(|| format!("vertex {vertex}"))
    }

    /// Whether the faces of a group are drawn: of an asset all.
    fn draws(&self, view: &View<'_>, file: &FileFacts, group: &str) -> bool {
        self.asset.is_some() || view.draws(file, group)
    }
}

const ASSET_VALUE: Case = &[(
    Makehuman2,
    Level::Error,
    "crashes with `ValueError` or `IndexError` when the asset is put on; models that wear it load only in part",
)];
const ASSET_INDEX: Case = &[(Makehuman2, Level::Error, STOPS_WITH_INDEX)];
const ASSET_OVERFLOW: Case = &[(Makehuman2, Level::Error, STOPS_WITH_OVERFLOW)];
