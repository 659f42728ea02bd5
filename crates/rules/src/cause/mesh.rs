//! Base meshes: one that an archive is read in place of, in which nobody meets what is off, and
//! that of MakeHuman 1.

use super::consequence::{STOPS_AT_START, UNREAD_MESH};
use mhlint_diag::{Application::Makehuman1, Case, Finding, Level};
use mhlint_formats::obj::Mesh;
use mhlint_repo::{FileFacts, View};

/// What becomes of MakeHuman 1 without its base mesh
/// (`docs/loaders/makehuman1/base-mesh.md#faults-of-the-base-mesh`).
const NO_START: Case = &[(Makehuman1, Level::Error, STOPS_AT_START)];

/// A finding on a base mesh: at most an info while an archive is read in its place. What keeps
/// MakeHuman 1 from putting on an asset keeps it from starting here.
pub(crate) fn weigh(view: &View<'_>, file: &FileFacts, finding: Finding) -> Finding {
    let is_refused = finding
        .breaks
        .iter()
        .any(|one| one.application == Makehuman1 && one.level == Level::Error);
    match () {
        () if view.is_replaced(&file.rel) => finding.case(UNREAD_MESH),
        () if view.is_makehuman1() && is_refused => finding.case(NO_START),
        () => finding,
    }
}

/// Whether an archive is read in place of the mesh and has the fault as well: then it is told of
/// the archive.
pub(crate) fn is_in_archive(view: &View<'_>, file: &FileFacts, fault: fn(&Mesh) -> bool) -> bool {
    let View::Makehuman2(own) = view else {
        return false;
    };
    let base = file
        .base()
        .and_then(|name| own.base(name))
        .filter(|_| view.is_replaced(&file.rel));
    base.and_then(|base| base.mesh_files.read?.mesh())
        .is_some_and(fault)
}
