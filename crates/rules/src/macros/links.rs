//! Entries of `macro.json` together with the files that their `t` leads to.

use std::collections::{BTreeMap, BTreeSet};

use super::fit::{Spellings, values_of};
use mhlint_diag::{Place, Suggestions};
use mhlint_formats::macro_json::{Link, Macrodef};
use mhlint_repo::makehuman2::{Base, View, is_beneath};
use mhlint_repo::{FileFacts, Reference, ReferenceKind, Resolution};

/// An entry with a file name.
#[derive(Clone, Copy)]
pub(super) struct MacroLink<'s> {
    pub(super) macrodef: &'s Macrodef,
    pub(super) link: &'s Link,
    pub(super) reference: &'s Reference<'s>,
}

/// All entries with a file name, in file order. An empty name is no reference.
pub(super) fn links<'s>(view: &'s View<'_>, base: &'s Base<'_>) -> Vec<MacroLink<'s>> {
    let mut by_pointer: BTreeMap<&str, &'s Reference<'s>> = BTreeMap::new();
    for reference in view.references_of(base) {
        if let (ReferenceKind::MacroTarget, Place::Pointer(pointer)) =
            (reference.kind, &reference.place)
        {
            by_pointer.insert(pointer, reference);
        }
    }
    let Some((_, macros)) = base.macro_file() else {
        return Vec::new();
    };
    let all = macros
        .macrodefs
        .iter()
        .flat_map(|macrodef| macrodef.links.iter().map(move |link| (macrodef, link)));
    all.filter_map(|(macrodef, link)| {
        let reference = by_pointer.get(macrodef.link_pointer(link, "t").as_str())?;
        Some(MacroLink {
            macrodef,
            link,
            reference,
        })
    })
    .collect()
}

impl<'s> MacroLink<'s> {
    pub(super) fn found(&self) -> Option<&'s FileFacts> {
        self.reference.found()
    }

    pub(super) fn is_missing(&self) -> bool {
        matches!(self.reference.resolution, Resolution::Missing)
    }

    /// Whether no file is there, for whatever reason.
    fn is_nowhere(&self) -> bool {
        self.reference.meant().is_none()
            && !matches!(self.reference.resolution, Resolution::NeedsSystem)
    }

    pub(super) fn place(&self) -> Place {
        self.reference.place.clone()
    }
}

/// Whether `t` ends in a suffix that the loader adds itself, or never reads.
#[expect(
    clippy::case_sensitive_file_extension_comparisons,
    reason = "the application compares so"
)]
pub(super) fn has_suffix(text: &str) -> bool {
    text.is_empty() || text.ends_with(".target") || text.ends_with(".gz")
}

/// The links of one definition among all [`links`].
pub(super) fn own_links<'l, 's>(
    all: &'l [MacroLink<'s>],
    macrodef: &Macrodef,
) -> &'l [MacroLink<'s>] {
    let start = all.partition_point(|link| link.macrodef.index < macrodef.index);
    let count = all
        .get(start..)
        .unwrap_or_default()
        .partition_point(|link| link.macrodef.index == macrodef.index);
    all.get(start..start + count).unwrap_or_default()
}

/// Targets in macro folders that could be read and that nothing names, rightly or wrongly written.
pub(super) fn unreferenced<'s>(
    view: &'s View<'_>,
    base: &'s Base<'_>,
    suggestions: &Suggestions,
) -> Vec<&'s FileFacts> {
    let Some(folder) = base.targets else {
        return Vec::new();
    };
    let mut named: BTreeSet<&str> = BTreeSet::new();
    let mut by_stem: BTreeMap<&str, &str> = BTreeMap::new();
    for file in folder.targets() {
        by_stem
            .entry(file.rel.trim_end_matches(".target"))
            .or_insert(&file.rel);
    }
    for reference in view
        .references_of(base)
        .filter(|reference| reference.kind.is_target())
    {
        if let Some(file) = reference.meant() {
            named.insert(&file.rel);
        } else {
            // `x.target` written for `x`, or a slip of the pen: those findings name the file.
            let stem = reference
                .rel
                .trim_end_matches(".target")
                .trim_end_matches(".target.gz");
            named.extend(by_stem.get(stem));
            named.extend(nearest_file(base, reference, suggestions).map(|file| file.rel.as_str()));
        }
    }
    let faulty = FaultyEntries::of(view, base);
    let readable = |file: &&FileFacts| {
        file.target()
            .is_some_and(|facts| facts.unreadable_rows == 0)
    };
    let free = folder
        .targets()
        .filter(|file| base.is_in_macro_folder(file) && !named.contains(file.rel.as_str()));
    free.filter(readable)
        .filter(|file| !faulty.mean(base, file))
        .collect()
}

/// Entries that lead to no file, for which something is reported.
struct FaultyEntries<'s> {
    /// Last parts of what they write.
    stems: BTreeSet<&'s str>,
    /// Their names, with their definitions.
    names: Spellings<'s, &'s Macrodef>,
}

impl<'s> FaultyEntries<'s> {
    fn of(view: &'s View<'_>, base: &'s Base<'_>) -> Self {
        let (mut stems, mut names) = (BTreeSet::new(), Vec::new());
        for link in links(view, base).iter().filter(|link| link.is_nowhere()) {
            stems.extend(last_part(link.reference.text));
            names.push((link.link.name.as_str(), link.macrodef));
        }
        for macrodef in base
            .macro_file()
            .iter()
            .flat_map(|(_, macros)| &macros.macrodefs)
        {
            stems.extend(macrodef.nameless.iter().filter_map(|text| last_part(text)));
            let empty = macrodef
                .links
                .iter()
                .filter(|link| link.target.as_deref() == Some(""));
            let own = empty.map(|link| &link.name).chain(&macrodef.unusable);
            names.extend(own.map(|name| (name.as_str(), macrodef)));
        }
        Self {
            stems,
            names: Spellings::of(names.into_iter()),
        }
    }

    /// Whether a file is what one of them was meant to name.
    fn mean(&self, base: &Base<'_>, file: &FileFacts) -> bool {
        let fitted = self.names.fitted_by(&values_of(file.stem()));
        self.stems.contains(file.stem())
            || fitted
                .iter()
                .any(|(_, macrodef)| is_in_folder(base, macrodef, file))
    }
}

fn last_part(text: &str) -> Option<&str> {
    text.rsplit(['/', '\\'])
        .next()
        .filter(|part| !part.is_empty())
}

/// Whether a target lies in the folder that a definition uses, or below it.
pub(super) fn is_in_folder(base: &Base<'_>, macrodef: &Macrodef, file: &FileFacts) -> bool {
    let name = base
        .targets
        .and_then(|folder| folder.name_of(file))
        .unwrap_or_default();
    macrodef
        .effective_folder
        .as_deref()
        .is_some_and(|folder| is_beneath(folder, name))
}

/// The file whose name is most like that of a missing one, in the same folder.
pub(super) fn nearest_file<'s>(
    base: &'s Base<'_>,
    reference: &Reference<'_>,
    suggestions: &Suggestions,
) -> Option<&'s FileFacts> {
    let folder = base.targets?;
    let (parent, _) = reference.rel.rsplit_once('/')?;
    let beside = folder.layer.below(parent);
    let beside = suggestions
        .looked_through(beside)
        .filter(|file| file.rel.ends_with(".target"));
    // The limit of the slip grows with the length of what is compared: the folder must not help.
    let own = reference.rel.strip_prefix(parent)?;
    let near = suggestions.nearest(own, beside.filter_map(|file| file.rel.strip_prefix(parent)))?;
    folder.layer.file(&format!("{parent}{near}"))
}
