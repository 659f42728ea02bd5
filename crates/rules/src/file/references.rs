//! Which files the references of a repository mean.

use std::collections::BTreeSet;

use super::icons::{self, Icons};
use mhlint_repo::makehuman2::{Base, View};
use mhlint_repo::{FileFacts, Layer, Reference, ReferenceKind, Resolution};

/// What the references of a repository say about its files.
pub(super) struct References<'r> {
    view: &'r View<'r>,
    used_icons: BTreeSet<String>,
    icons: Icons<'r>,
    /// Names of files that are not there, of which one may be there packed.
    missing: BTreeSet<&'r str>,
}

impl<'r> References<'r> {
    pub(super) fn of(view: &'r View<'_>, base: &'r Base<'_>) -> Self {
        let missing = view
            .references_of(base)
            .filter(|one| matches!(one.resolution, Resolution::Missing));
        let missing = missing.map(|reference| reference.rel.as_str()).collect();
        Self {
            view,
            used_icons: icons::in_use(view, base),
            icons: Icons::of(view, base),
            missing,
        }
    }

    /// The layer whose files are looked at.
    pub(super) fn layer(&self) -> &'r Layer {
        self.view.layers.checked
    }

    /// Whether no slider asks for an icon, and no fault that is told elsewhere is why none does.
    pub(super) fn leave_icon(&self, base: &Base<'_>, icon: &FileFacts) -> bool {
        icons::is_store(self.layer(), base, icon)
            && !self.used_icons.contains(&icon.rel)
            && !self.icons.is_misspelt(icon.file_name())
            && !self.icons.is_of_unused_target(icon.stem())
    }

    /// Whether an icon in use, a texture, or what something names but for capitals: the finding on
    /// that reference names the file.
    pub(super) fn mean(&self, file: &FileFacts) -> bool {
        let means = |reference: &Reference<'_>| match reference.resolution {
            // A texture may be called anything.
            Resolution::Found(_) => reference.kind == ReferenceKind::Texture,
            _ => true,
        };
        self.used_icons.contains(&file.rel)
            || self.view.references.to_file(file).any(means)
            || file
                .rel
                .strip_suffix(".gz")
                .is_some_and(|unpacked| self.missing.contains(unpacked))
    }
}
