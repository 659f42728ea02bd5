//! How many vertices of the mesh of an asset MPFB keeps (formats/mpfb.md §26.2; formats/mpfb-observed.md 1.4).

use crate::formats::asset_mesh::AssetMesh;
use crate::repo::FileFacts;
use crate::repo::mpfb::View;

/// Vertices that are kept: those of faces, or all if there are none.
pub(in crate::rules) fn kept(mesh: &AssetMesh) -> usize {
    let unused = usize::try_from(mesh.facts.unused.count).unwrap_or(usize::MAX);
    if mesh.faces == 0 { mesh.facts.vertices } else { mesh.facts.vertices.saturating_sub(unused) }
}

/// Whether an asset has rows for more vertices of this mesh than are kept.
pub(super) fn counts_loose(view: &View<'_>, file: &FileFacts) -> bool {
    let mut worn = view.worn_anywhere().filter_map(|worn| Some((worn.clothes()?, worn.mesh()?)));
    worn.any(|(clothes, (own, mesh))| own.path == file.path && clothes.flow.rows > kept(mesh))
}
