//! Which icons of sliders are in use.
//!
//! Gets a repository and an icon, says whether a slider asks for it, and whether a fault that is
//! told elsewhere is why none does.

use std::collections::{BTreeMap, BTreeSet};

use super::super::cause::overlay::has_sliders;
use mhlint_diag::Sought;
use mhlint_repo::makehuman2::{Base, TargetFolder, View};
use mhlint_repo::{FileFacts, Layer, Reference, ReferenceKind};

/// Icons count as unused only where the sliders that could name them are known: in the folder in
/// use.
pub(super) fn is_store(layer: &Layer, base: &Base<'_>, file: &FileFacts) -> bool {
    let inside = |folder: Option<TargetFolder<'_>>| {
        folder.is_some_and(|folder| {
            std::ptr::eq(folder.layer, layer)
                && file.rel.starts_with(&format!("{}/icons/", folder.rel()))
        })
    };
    let known = has_sliders(base) && !base.has_unreadable_icons();
    (known && inside(base.targets)) || inside(base.user_targets)
}

/// Names of missing icons that are compared with others; where thousands are missing, none is a
/// slip of the pen.
const COMPARED: usize = 4096;

/// What the sliders of a base say about icons, gathered once for all of its icons.
pub(super) struct Icons<'r> {
    /// Names of the icons that are asked for and not there.
    lost: BTreeMap<&'r str, Sought<'r>>,
    /// Names that sliders with misspelt keys were meant to ask for.
    meant: BTreeSet<&'r str>,
    /// Names of the targets that nothing uses, without extension.
    unused_targets: BTreeSet<&'r str>,
    /// The same without their last word: pairs of targets share an icon.
    unused_pairs: BTreeSet<&'r str>,
}

impl<'r> Icons<'r> {
    pub(super) fn of(view: &'r View<'_>, base: &'r Base<'_>) -> Self {
        let icons = view
            .references_of(base)
            .filter(|reference| reference.kind == ReferenceKind::Icon);
        let lost = icons.filter(|reference| reference.found().is_none());
        // With a wrong path in front of it, the name itself may be right.
        let names = lost.map(|reference| {
            reference
                .text
                .rsplit(['/', '\\'])
                .next()
                .unwrap_or_default()
        });
        let is_use =
            |reference: &Reference<'_>| reference.base == base.name && reference.kind.is_target();
        let is_used = |file: &FileFacts| view.references.to_file(file).any(is_use);
        let files = base
            .targets
            .iter()
            .flat_map(|folder| folder.layer.below(&folder.rel()))
            .filter(|file| file.target().is_some());
        let unused_targets: BTreeSet<&str> = files
            .filter(|file| !is_used(file))
            .map(FileFacts::stem)
            .collect();
        Self {
            lost: names.map(|name| (name, Sought::new(name))).collect(),
            meant: base
                .sliders
                .iter()
                .filter_map(|slider| slider.as_meant().icon.as_deref())
                .collect(),
            unused_pairs: unused_targets
                .iter()
                .filter_map(|stem| Some(stem.rsplit_once('-')?.0))
                .collect(),
            unused_targets,
        }
    }

    /// Whether a slider asks for an icon that is not there and must mean this one: that name is the
    /// fault.
    pub(super) fn is_misspelt(&self, name: &str) -> bool {
        self.lost.contains_key(name)
            || self.meant.contains(name)
            || self.lost.len() <= COMPARED
                && self.lost.values().any(|written| written.may_mean(name))
    }

    /// Whether the picture is called after a target of a slider that is gone: that nothing uses the
    /// target is the news.
    pub(super) fn is_of_unused_target(&self, icon: &str) -> bool {
        let words = icon
            .match_indices('-')
            .filter_map(|(end, _)| icon.get(..end));
        self.unused_pairs.contains(icon)
            || words
                .chain([icon])
                .any(|stem| self.unused_targets.contains(stem))
    }
}

/// Paths of the icons that some slider asks for, relative to the root.
pub(super) fn in_use(view: &View<'_>, base: &Base<'_>) -> BTreeSet<String> {
    let icons = view
        .references_of(base)
        .filter(|reference| reference.kind == ReferenceKind::Icon);
    let mut used: BTreeSet<String> = icons
        .filter_map(|icon| Some(icon.meant()?.rel.clone()))
        .collect();
    used.extend(generated_icons(base));
    used
}

/// Icons that the sliders get which MakeHuman 2 makes from user targets
/// (`docs/loaders/makehuman2/user-targets.md#names-and-keys`).
fn generated_icons<'a>(base: &'a Base<'_>) -> impl Iterator<Item = String> + 'a {
    let folders = base.user_targets.into_iter();
    folders.flat_map(|folder| {
        let names = folder
            .targets()
            .filter_map(move |file| folder.name_of(file));
        names.flat_map(move |name| {
            let flat = name.replacen('/', "-", 1);
            let pair = flat.strip_suffix("-incr").map(str::to_owned);
            [Some(flat), pair]
                .into_iter()
                .flatten()
                .map(move |stem| format!("{}/icons/{stem}.png", folder.rel()))
        })
    })
}
