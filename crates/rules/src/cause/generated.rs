//! Files that MakeHuman 2 writes itself, for the targets of a user.

use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::Base;

/// Whether the file is the `modelling.json` of a base that MakeHuman 2 makes from the user's
/// targets.
pub(crate) fn is_generated_for(base: &Base<'_>, file: &FileFacts) -> bool {
    base.user_modelling
        .file()
        .is_some_and(|own| std::ptr::eq(own, file))
}
