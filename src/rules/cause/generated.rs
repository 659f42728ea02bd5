//! Files that MakeHuman 2 writes itself, for the targets of a user.

use crate::repo::makehuman2::Base;
use crate::repo::{FileFacts, Layers};

/// Whether a path lies in the target folder of a user, whose JSON MakeHuman 2 writes itself.
pub(in crate::rules) fn is_generated(layers: Layers<'_>, rel: &str) -> bool {
    let user = layers.user.is_some_and(|user| std::ptr::eq(user, layers.checked));
    user && !layers.is_one_root() && rel.starts_with("target/")
}

/// Whether the file is the `modelling.json` of a base that MakeHuman 2 makes from the user's targets.
pub(in crate::rules) fn is_generated_for(base: &Base<'_>, file: &FileFacts) -> bool {
    base.user_modelling.file().is_some_and(|own| std::ptr::eq(own, file))
}
