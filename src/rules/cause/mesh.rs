//! A mesh that does not belong to the data around it: whatever is off against it is its doing.

use crate::repo::{FileFacts, View};

/// Whether the base mesh of a file has another number of vertices than all the rest is made for (`base-vertex-count`).
pub(in crate::rules) fn is_beside_foreign_mesh(view: &View<'_>, file: &FileFacts) -> bool {
    match view {
        View::Makehuman2(own) => {
            file.base().and_then(|name| own.base(name)).is_some_and(|base| base.foreign_mesh.is_some())
        }
        View::Makehuman1(_) | View::Mpfb(_) => false,
    }
}
