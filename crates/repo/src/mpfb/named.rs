//! What MPFB finds by a name alone: targets (`docs/loaders/mpfb/targets.md#finding-by-name`), and
//! files of assets (`docs/loaders/mpfb/folders.md#lookups`).

use std::collections::{BTreeMap, BTreeSet};

use super::sliders::is_custom;
use super::view::OWN;
use crate::{FileFacts, Layers, Worn};
use mhlint_discover::Layout;
use mhlint_formats::mhclo::Entry;
use mhlint_source::file_name;

/// Targets that are found by their names, each under its file name in small letters.
#[derive(Debug, Default)]
pub struct NamedTargets<'a> {
    /// A phase with any hit ends the search: packed ones of the system, then custom ones, then all.
    phases: [Phase<'a>; 3],
}

/// Names with their files, sorted: those that begin alike stand together and are not counted one by
/// one.
type Phase<'a> = Vec<(String, &'a FileFacts)>;

/// The place of the first name from this one on.
fn place_of(phase: &Phase<'_>, name: &str) -> usize {
    phase.partition_point(|(other, _)| other.as_str() < name)
}

fn has(phase: &Phase<'_>, name: &str) -> bool {
    let next = phase.get(place_of(phase, name));
    next.is_some_and(|(other, _)| other == name)
}

fn beginning_with<'p, 'a>(phase: &'p Phase<'a>, beginning: &str) -> &'p [(String, &'a FileFacts)] {
    let from = phase.get(place_of(phase, beginning)..).unwrap_or_default();
    let end = from.partition_point(|(name, _)| name.starts_with(beginning));
    from.get(..end).unwrap_or_default()
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
        let mut phases: [BTreeMap<String, &FileFacts>; 3] = Default::default();
        for layer in layers.strongest_first().chain(layers.beside) {
            let is_system = layers
                .system
                .is_some_and(|system| std::ptr::eq(system, layer));
            // Links to folders are not followed.
            let files = layer.files.values();
            for file in files.filter(|file| !layer.is_behind_link(&file.rel)) {
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
                for (phase, _) in phases.iter_mut().zip(own).filter(|(_, is_in)| *is_in) {
                    phase.entry(name.to_lowercase()).or_insert(file);
                }
            }
        }
        Self {
            phases: phases.map(|phase| phase.into_iter().collect()),
        }
    }

    /// What a name leads to, in whatever capitals.
    pub fn find(&self, name: &str) -> NamedTarget<'a> {
        let name = name.to_lowercase();
        let exact = SUFFIXES.map(|suffix| format!("{name}{suffix}"));
        for phase in &self.phases {
            if exact.iter().any(|name| has(phase, name)) {
                return NamedTarget::Found;
            }
            match beginning_with(phase, &name) {
                [] => {}
                [_] => return NamedTarget::Found,
                several @ [(_, file), ..] => return NamedTarget::AnyOf(several.len(), file),
            }
        }
        NamedTarget::Missing
    }

    /// A name in small letters among those that MPFB brings, and finds first: this one, else the
    /// first that begins so.
    pub fn shipped<'n>(&'n self, beginning: &'n str) -> Option<&'n str> {
        let [shipped, ..] = &self.phases;
        if has(shipped, &format!("{beginning}.target.gz")) {
            return Some(beginning);
        }
        let (name, _) = beginning_with(shipped, beginning).first()?;
        name.strip_suffix(".target.gz")
            .filter(|name| name.starts_with(beginning))
    }

    /// The names of all, for suggestions.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        let files = self.phases.iter().flatten();
        files.filter_map(|(_, file)| {
            SUFFIXES
                .iter()
                .find_map(|suffix| file.file_name().strip_suffix(suffix))
        })
    }
}

/// Files of assets by their names: folders count only where several have one name.
#[derive(Debug, Default)]
pub struct NamedFiles<'a> {
    /// The first file of each name.
    first: BTreeMap<&'a str, &'a FileFacts>,
    /// Sections with the names in them.
    in_sections: BTreeSet<(&'a str, &'a str)>,
}

impl<'a> NamedFiles<'a> {
    /// Those of all layers.
    pub(super) fn of(layers: Layers<'a>) -> Self {
        let mut found = Self::default();
        let files = layers
            .strongest_first()
            .chain(layers.beside)
            .flat_map(|layer| layer.files.values());
        for file in files {
            found.first.entry(file.file_name()).or_insert(file);
            found
                .in_sections
                .insert((section_of(file), file.file_name()));
        }
        found
    }

    /// Whether a reference leads to a file of its name below the folder of a section.
    pub fn has(&self, section: &str, reference: &str) -> bool {
        let name = file_name(reference);
        self.in_sections.contains(&(section, name))
    }

    /// The folder at the top that holds a file of the name.
    pub fn section_of(&self, reference: &str) -> Option<&'a str> {
        let name = file_name(reference);
        self.first
            .get(name)
            .and_then(|file| file.rel.split_once('/'))
            .map(|(top, _)| top)
    }

    /// The names of all in a section, for suggestions.
    pub fn names<'s>(&'s self, section: &'s str) -> impl Iterator<Item = &'a str> + use<'a, 's> {
        self.in_sections
            .range((section, "")..)
            .take_while(move |(own, _)| *own == section)
            .map(|(_, name)| *name)
    }
}

/// The folder at the top, as it should be called: that it has other capitals is told of the folder.
fn section_of(file: &FileFacts) -> &str {
    let top = file.rel.split_once('/').map_or("", |(folder, _)| folder);
    Layout::of(OWN).folder_in_other_case(top).unwrap_or(top)
}
