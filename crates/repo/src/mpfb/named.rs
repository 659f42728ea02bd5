//! What MPFB finds by a name alone: targets (`docs/loaders/mpfb/targets.md#finding-by-name`), and
//! files of assets (`docs/loaders/mpfb/folders.md#lookups`).

use std::collections::BTreeMap;

use super::sliders::is_custom;
use super::view::OWN;
use crate::{FileFacts, Layers, Worn};
use mhlint_diag::{Grouped, grouped};
use mhlint_discover::Layout;
use mhlint_formats::mhclo::Entry;
use mhlint_source::is_below;

/// Targets that are found by their names, each under its file name in small letters.
#[derive(Debug, Default)]
pub struct NamedTargets<'a> {
    /// A phase with any hit ends the search: packed ones of the system, then custom ones, then all.
    phases: [BTreeMap<String, &'a FileFacts>; 3],
}

/// What a name leads to.
#[derive(Debug, Clone, Copy)]
pub enum NamedTarget<'a> {
    /// A target of this name, or the only one that begins so.
    Found,
    /// Several that begin so: which one is taken depends on the disk.
    AnyOf(usize, &'a FileFacts),
    /// None.
    Missing,
}

/// The uuid by which saved characters know what is worn.
pub fn uuid<'a>(worn: &Worn<'a>) -> Option<&'a str> {
    let clothes = worn.clothes()?;
    let line = clothes.flow.line_of("uuid")?;
    clothes
        .entries
        .iter()
        .find(|entry| entry.line == line)
        .map(Entry::word)
}

const SUFFIXES: [&str; 2] = [".target.gz", ".target"];

impl<'a> NamedTargets<'a> {
    /// Those of all layers.
    pub(super) fn of(layers: Layers<'a>) -> Self {
        let mut found = Self::default();
        for layer in layers.strongest_first().chain(layers.beside) {
            let is_system = layers
                .system
                .is_some_and(|system| std::ptr::eq(system, layer));
            // Links to folders are not followed.
            let is_linked = |file: &FileFacts| {
                layer
                    .linked_folders
                    .iter()
                    .any(|folder| is_below(&file.rel, folder))
            };
            for file in layer.files.values().filter(|file| !is_linked(file)) {
                let name = file.file_name();
                if !SUFFIXES.iter().any(|suffix| name.ends_with(suffix)) {
                    continue;
                }
                let is_first =
                    is_system && file.rel.starts_with("targets/") && name.ends_with(".gz");
                let section = section_of(file);
                // One of a user where nobody looks for it is told where it lies.
                let is_elsewhere = !is_system && section != "custom";
                let is_own = is_custom(&file.rel) || section == "custom";
                let own = [is_first, is_own, section == "targets" || is_elsewhere];
                for (phase, _) in found.phases.iter_mut().zip(own).filter(|(_, is_in)| *is_in) {
                    phase.entry(name.to_lowercase()).or_insert(file);
                }
            }
        }
        found
    }

    /// What a name leads to, in whatever capitals.
    pub fn find(&self, name: &str) -> NamedTarget<'a> {
        let name = name.to_lowercase();
        let exact = |phase: &BTreeMap<String, &'a FileFacts>| {
            SUFFIXES
                .iter()
                .any(|suffix| phase.contains_key(&format!("{name}{suffix}")))
        };
        for phase in &self.phases {
            if exact(phase) {
                return NamedTarget::Found;
            }
            let mut beginning = phase
                .range(name.clone()..)
                .take_while(|(other, _)| other.starts_with(&name));
            match (beginning.next(), beginning.count()) {
                (Some(_), 0) => return NamedTarget::Found,
                (Some((_, file)), more) => return NamedTarget::AnyOf(more + 1, file),
                (None, _) => {}
            }
        }
        NamedTarget::Missing
    }

    /// A name in small letters among those that MPFB brings, and finds first: this one, else the
    /// first that begins so.
    pub fn shipped(&self, beginning: &str) -> Option<&str> {
        let [shipped, ..] = &self.phases;
        let exact = shipped.get_key_value(&format!("{beginning}.target.gz"));
        let (name, _) = exact.or_else(|| shipped.range(beginning.to_owned()..).next())?;
        name.strip_suffix(".target.gz")
            .filter(|name| name.starts_with(beginning))
    }

    /// The names of all, for suggestions.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        let files = self.phases.iter().flat_map(BTreeMap::values);
        files.filter_map(|file| {
            SUFFIXES
                .iter()
                .find_map(|suffix| file.file_name().strip_suffix(suffix))
        })
    }
}

/// Files of assets by their names: folders count only where several have one name.
#[derive(Debug, Default)]
pub struct NamedFiles<'a>(Grouped<&'a str, &'a FileFacts>);

impl<'a> NamedFiles<'a> {
    /// Those of all layers.
    pub(super) fn of(layers: Layers<'a>) -> Self {
        let files = layers
            .strongest_first()
            .chain(layers.beside)
            .flat_map(|layer| layer.files.values());
        Self(grouped(files.map(|file| (file.file_name(), file))))
    }

    /// Whether a reference leads to a file of its name below the folder of a section.
    pub fn has(&self, section: &str, reference: &str) -> bool {
        let name = reference.rsplit('/').next().unwrap_or(reference);
        self.0
            .get(name)
            .into_iter()
            .flatten()
            .any(|file| is_in(file, section))
    }

    /// The folder at the top that holds a file of the name.
    pub fn section_of(&self, reference: &str) -> Option<&'a str> {
        let name = reference.rsplit('/').next().unwrap_or(reference);
        self.0
            .get(name)
            .and_then(|files| files.first())
            .and_then(|file| file.rel.split_once('/'))
            .map(|(top, _)| top)
    }

    /// The names of all in a section, for suggestions.
    pub fn names(&self, section: &str) -> impl Iterator<Item = &'a str> {
        let is_meant = move |(_, files): &(&&'a str, &Vec<&FileFacts>)| {
            files.iter().any(|file| is_in(file, section))
        };
        self.0.iter().filter(is_meant).map(|(name, _)| *name)
    }
}

/// The folder at the top decides.
fn is_in(file: &FileFacts, section: &str) -> bool {
    section_of(file) == section
}

/// The folder at the top, as it should be called: that it has other capitals is told of the folder.
fn section_of(file: &FileFacts) -> &str {
    let top = file.rel.split_once('/').map_or("", |(folder, _)| folder);
    Layout::of(OWN).folder_in_other_case(top).unwrap_or(top)
}
