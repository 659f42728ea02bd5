//! A mesh that an archive is read in place of: whatever is off in it nobody meets.

use super::consequence::UNREAD_MESH;
use crate::diag::Finding;
use crate::formats::obj::Mesh;
use crate::repo::{FileFacts, View};

/// A finding on a mesh: at most an info while an archive is read in its place.
pub(in crate::rules) fn weigh(view: &View<'_>, file: &FileFacts, finding: Finding) -> Finding {
    if view.is_replaced(&file.rel) { finding.case(UNREAD_MESH) } else { finding }
}

/// Whether an archive is read in place of the mesh and has the fault as well: then it is told of the archive.
pub(in crate::rules) fn is_in_archive(view: &View<'_>, file: &FileFacts, fault: fn(&Mesh) -> bool) -> bool {
    let View::Makehuman2(own) = view else { return false };
    let base = file.base().and_then(|name| own.base(name)).filter(|_| view.is_replaced(&file.rel));
    base.and_then(|base| base.mesh_files.read?.mesh()).is_some_and(fault)
}
