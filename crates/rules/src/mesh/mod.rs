//! Rules on meshes: of a base, as OBJ or packed, and of assets.

mod degenerate_face;
mod duplicate_face;
mod face_out_of_range;
mod group_name;
mod inside_out;
mod missing_groups;
mod name_clash;
mod ngon;
mod no_faces;
mod no_uv;
mod non_finite;
mod not_manifold;
mod packed_difference;
mod packed_mesh;
mod partial_uv;
mod pole;
mod reopened_group;
mod stale_binary;
mod syntax;
mod unused_vertex;
mod vertex_order;

use super::Rule;
use super::cause::mesh::weigh;
use super::proxy::{STOPS_WITH_INDEX, STOPS_WITH_OVERFLOW};
use mhlint_diag::{Application::Makehuman2, Case, Finding, Level};
use mhlint_discover::{Kind, Single};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::obj::{Mesh, MeshFacts};
use mhlint_repo::makehuman1::mesh_archive;
use mhlint_repo::{FileFacts, ReferenceKind, View};

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &degenerate_face::RULE,
    &duplicate_face::RULE,
    &face_out_of_range::RULE,
    &group_name::RULE,
    &inside_out::RULE,
    &missing_groups::RULE,
    &name_clash::RULE,
    &ngon::RULE,
    &no_faces::RULE,
    &no_uv::RULE,
    &non_finite::RULE,
    &not_manifold::RULE,
    &partial_uv::RULE,
    &pole::RULE,
    &reopened_group::RULE,
    &stale_binary::RULE,
    &syntax::RULE,
    &unused_vertex::RULE,
    &vertex_order::RULE,
];

/// A mesh that is read: of a base, or of an asset.
#[derive(Clone, Copy)]
struct ReadMesh<'f> {
    facts: &'f MeshFacts,
    /// Faces that could be read.
    faces: usize,
    uvs: usize,
    asset: Option<&'f AssetMesh>,
}

/// The mesh of a body. One that MakeHuman 1 packed has been read by it before: what is wrong with
/// its archive is told as such.
fn of_body(file: &FileFacts) -> Option<&Mesh> {
    file.mesh().filter(|_| file.kind != Kind::PackedBaseMesh)
}

/// What is read of a file, if it is a mesh that is read.
fn read<'f>(view: &View<'_>, file: &'f FileFacts) -> Option<ReadMesh<'f>> {
    if let Some(mesh) = of_body(file) {
        return Some(ReadMesh {
            facts: &mesh.facts,
            faces: mesh.faces.len(),
            uvs: mesh.uvs.len(),
            asset: None,
        });
    }
    of_asset(view, file).map(ReadMesh::of)
}

/// The mesh that MakeHuman 2 shows for a lamp, which nothing names
/// (`docs/loaders/makehuman2/program.md#lamp-symbol`).
fn lamp_symbol<'f>(view: &View<'_>, file: &'f FileFacts) -> Option<ReadMesh<'f>> {
    let is_read = (view.layout().single)(&file.rel) == Some(Single::LampSymbol)
        && view.layers().checks_system();
    let asset = file
        .asset_mesh()
        .filter(|_| is_read && file.encoding.invalid_utf8_at.is_none());
    asset.map(ReadMesh::of)
}

/// The mesh of an asset, if some asset names it.
fn of_asset<'f>(view: &View<'_>, file: &'f FileFacts) -> Option<&'f AssetMesh> {
    let is_named = |_: &&AssetMesh| {
        view.references()
            .to_file(file)
            .any(|one| one.kind == ReferenceKind::AssetMesh)
    };
    // An archive beside it is read in its place.
    let is_packed = |_: &&AssetMesh| {
        view.is_makehuman1() && mesh_archive(view.layers().checked, &file.rel).is_some()
    };
    let mesh = file
        .asset_mesh()
        .filter(|_| file.encoding.invalid_utf8_at.is_none())
        .filter(is_named);
    mesh.filter(|mesh| !is_packed(mesh))
}

impl<'f> ReadMesh<'f> {
    fn of(asset: &'f AssetMesh) -> Self {
        Self {
            facts: &asset.facts,
            faces: asset.faces,
            uvs: asset.uvs,
            asset: Some(asset),
        }
    }

    /// A finding with the consequence for the sort of mesh.
    fn weigh(
        &self,
        view: &View<'_>,
        file: &FileFacts,
        finding: Finding,
        of_asset: Case,
    ) -> Finding {
        if self.asset.is_some() {
            finding.case(of_asset)
        } else {
            weigh(view, file, finding)
        }
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
    "crashes with `ValueError` or `IndexError` when the asset is put on; models that wear it load \
        only in part",
)];
const ASSET_INDEX: Case = &[(Makehuman2, Level::Error, STOPS_WITH_INDEX)];
const ASSET_OVERFLOW: Case = &[(Makehuman2, Level::Error, STOPS_WITH_OVERFLOW)];
