//! Which targets the application reads and nobody uses.
//!
//! Says nothing where the files that would use them are missing, broken or of another layer.

use std::collections::{BTreeMap, BTreeSet};

use super::{Base, TargetFolder};
use crate::{FileFacts, Layers, ReferenceKind, References};
use mhlint_source::parent;

/// How targets are used, of all bases.
#[derive(Debug, Default)]
pub(super) struct Usage<'a> {
    /// How a file is used, by printed path; a macro outweighs a slider because it is applied at
    /// start.
    users: BTreeMap<&'a str, ReferenceKind>,
    /// Unused targets by base.
    unused: BTreeMap<&'a str, Vec<&'a FileFacts>>,
    /// Printed paths of all unused targets.
    unused_paths: BTreeSet<&'a str>,
}

impl<'a> Usage<'a> {
    pub(super) fn of(layers: Layers<'a>, bases: &[Base<'a>], references: &References<'a>) -> Self {
        let mut usage = Self {
            users: users(references),
            ..Self::default()
        };
        usage.add_links(layers);
        for base in bases {
            let unused = usage.unused_of(base);
            usage
                .unused_paths
                .extend(unused.iter().map(|file| file.path.as_str()));
            usage.unused.insert(base.name, unused);
        }
        usage
    }

    /// How a file is used as a target.
    pub(super) fn of_file(&self, file: &FileFacts) -> Option<ReferenceKind> {
        self.users.get(file.path.as_str()).copied()
    }

    /// Whether a file is a target that is read and that nothing uses.
    pub(super) fn is_unused(&self, file: &FileFacts) -> bool {
        self.unused_paths.contains(file.path.as_str())
    }

    /// The unused targets of a base.
    pub(super) fn unused(&self, base: &Base<'_>) -> &[&'a FileFacts] {
        self.unused
            .get(base.name)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// Who uses a file through a link uses the file, and the other way round.
    fn add_links(&mut self, layers: Layers<'a>) {
        let linked =
            |link: &'a FileFacts| Some([link, layers.checked.file(link.link_to.as_deref()?)?]);
        for pair in layers.checked.files.values().filter_map(linked) {
            if let Some(kind) = pair.iter().filter_map(|file| self.of_file(file)).min() {
                self.users
                    .extend(pair.map(|file| (file.path.as_str(), kind)));
            }
        }
    }

    /// Targets of the folder in use, and user targets too deep to become sliders.
    fn unused_of(&self, base: &Base<'a>) -> Vec<&'a FileFacts> {
        let mut unused = self.user_targets(base);
        if let Some(folder) = base.targets.filter(|folder| can_tell(base, *folder)) {
            unused.extend(self.targets(base, folder));
        }
        unused
    }

    fn targets(&self, base: &Base<'a>, folder: TargetFolder<'a>) -> Vec<&'a FileFacts> {
        let is_used = |file: &&FileFacts| self.of_file(file).is_some();
        let used_folders: BTreeSet<&str> = folder
            .targets()
            .filter(is_used)
            .map(|file| parent(&file.rel))
            .collect();
        // A base may do without macro.json. Then a folder of which nothing is used may wait for
        // one.
        let has_macros = base.macro_file().is_some();
        let is_checked = |file: &&FileFacts| has_macros || used_folders.contains(parent(&file.rel));
        // What a slider uses that is reported for itself is not known, or known under a misspelt
        // key.
        let is_explained = |file: &&FileFacts| {
            let Some(name) = folder.name_of(file) else {
                return false;
            };
            base.means_target(name) || base.has_unreadable_sliders() && !base.keeps_for_macros(name)
        };
        folder
            .targets()
            .filter(|file| !is_used(file))
            .filter(is_checked)
            .filter(|file| !is_explained(file))
            .collect()
    }

    fn user_targets(&self, base: &Base<'a>) -> Vec<&'a FileFacts> {
        let Some(folder) = base.user_targets else {
            return Vec::new();
        };
        let is_deep = |file: &&FileFacts| {
            folder
                .name_of(file)
                .is_some_and(|name| name.matches('/').count() > 1)
        };
        folder
            .targets()
            .filter(is_deep)
            .filter(|file| self.of_file(file).is_none())
            .collect()
    }
}

fn users<'a>(references: &References<'a>) -> BTreeMap<&'a str, ReferenceKind> {
    let mut users = BTreeMap::new();
    for reference in references
        .iter()
        .filter(|reference| reference.kind.is_target())
    {
        if let Some(file) = reference.meant() {
            let known = users.entry(file.path.as_str()).or_insert(reference.kind);
            *known = reference.kind.min(*known);
        }
    }
    users
}

/// Whether sliders and macros that are meant for the folder are there and could be read.
fn can_tell(base: &Base<'_>, folder: TargetFolder<'_>) -> bool {
    let own_sliders = folder
        .layer
        .file(&format!("{}/modelling.json", folder.rel()));
    let sliders_in_use = base.modelling.winner().map(|(file, _)| file);
    let broken = base.modelling.contarget.is_refused()
        || base.macros.contarget.is_refused()
        || base.macros.is_broken();
    !broken
        && own_sliders
            .zip(sliders_in_use)
            .is_some_and(|(own, used)| std::ptr::eq(own, used))
}

impl Base<'_> {
    /// Whether a target lies in a folder of a macro definition; those have a rule of their own.
    pub fn keeps_for_macros(&self, name: &str) -> bool {
        self.macro_folders.hold_directly(name)
    }
}
