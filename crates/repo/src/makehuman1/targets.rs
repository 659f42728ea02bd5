//! Targets by the words of their paths, and the user's own
//! (`docs/loaders/makehuman1/targets.md#names`,
//! `docs/loaders/makehuman1/modifiers.md#custom-targets`).

use std::collections::{BTreeMap, BTreeSet};

use super::target_archive::TargetArchive;
use super::view::OWN;
use crate::{FileFacts, Layer, Layers};
use mhlint_discover::{Kind, Layout, Single, TARGETS_NPZ};
use mhlint_formats::npz::targets::PackedTarget;
use mhlint_formats::target::name::{Clash, TargetName, Values, values_below};
use mhlint_source::folder_and_name;

/// The folder of the user's own targets.
pub const CUSTOM: &str = "custom";

/// All targets that the program finds.
#[derive(Debug, Default)]
pub struct Targets<'a> {
    /// Those of the system, wherever they lie in its data, by path.
    pub shipped: Vec<NamedTarget<'a>>,
    /// Places of those of each group.
    by_group: BTreeMap<String, Vec<usize>>,
    /// The first paths at which two values of one category meet: no target is found at all.
    pub clashes: Vec<PathClash<'a>>,
    /// Those of the user, by path.
    pub custom: Vec<CustomTarget<'a>>,
    /// The archive that may stand for those of the system.
    pub archive: Option<TargetArchive<'a>>,
    /// Whether it is one of other targets than the modifiers move: none of its macros is there.
    pub is_foreign: bool,
    /// Groups of texts that the archive does not have.
    hidden: BTreeSet<String>,
    /// Places of those of the system, by path.
    places: BTreeMap<&'a str, usize>,
    /// Whether nobody can tell which are found: an archive is there that was not read.
    pub is_packed: bool,
}

/// A target of the system.
#[derive(Debug)]
pub struct NamedTarget<'a> {
    /// Its text; the archive, where that alone has it.
    pub file: &'a FileFacts,
    /// The path that the program has for it, below the data.
    pub rel: String,
    /// What that tells.
    pub name: TargetName,
}

/// A target of the user, with a slider of its own.
#[derive(Debug)]
pub struct CustomTarget<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The full name of its modifier.
    pub name: String,
}

/// Where two values of one category meet.
#[derive(Debug)]
pub struct PathClash<'a> {
    /// The folder or the target, relative to the root.
    pub rel: &'a str,
    /// The target, where it is one.
    pub file: Option<&'a FileFacts>,
    /// What meets.
    pub clash: Clash,
}

impl NamedTarget<'_> {
    /// What its members in an archive are called after.
    pub fn member(&self) -> &str {
        self.rel.strip_suffix(".target").unwrap_or(&self.rel)
    }
}

impl<'a> Targets<'a> {
    pub(super) fn of(layers: Layers<'a>) -> Self {
        let mut targets = Self {
            custom: custom(layers),
            ..Self::default()
        };
        let Some(system) = layers.system else {
            return targets;
        };
        targets.archive = TargetArchive::of(system);
        if let Some(archive) = targets
            .archive
            .as_ref()
            .filter(|archive| archive.unused.is_none())
        {
            let found: Vec<(String, &FileFacts)> = archive
                .names()
                .map(|name| (format!("{name}.target"), archive.file))
                .collect();
            for (rel, archive) in found {
                let file = system.file(&rel).unwrap_or(archive);
                targets.add(&rel, file);
            }
            targets.hidden = hidden(system, &targets.places);
            return targets;
        }
        targets.is_packed = targets.archive.is_none() && system.file(TARGETS_NPZ).is_some();
        if !targets.is_packed {
            targets.clashes = clashes(system);
        }
        for file in system
            .files
            .values()
            .filter(|file| file.kind_in(OWN) == Kind::Target && !file.is_loose)
        {
            targets.add(&file.rel, file);
        }
        // An archive that cannot be used and no text: that is told once.
        targets.is_packed |= targets.shipped.is_empty() && targets.archive.is_some();
        targets
    }

    /// One that the program finds under this path. One with a clash it does not find.
    fn add(&mut self, rel: &str, file: &'a FileFacts) {
        let Ok(name) = TargetName::of(rel) else {
            return;
        };
        let place = self.shipped.len();
        self.by_group.entry(name.group()).or_default().push(place);
        if file.kind_in(OWN) == Kind::Target {
            self.places.insert(&file.rel, place);
        }
        self.shipped.push(NamedTarget {
            file,
            rel: rel.to_owned(),
            name,
        });
    }

    /// Whether there is a text for a group, and an archive without it.
    pub fn hides(&self, group: &str) -> bool {
        self.hidden.contains(group)
    }

    /// Whether the program takes them from an archive.
    pub fn are_archived(&self) -> bool {
        self.archive
            .as_ref()
            .is_some_and(|archive| archive.unused.is_none())
    }

    /// The targets that the program reads from an archive, with their members, the archive first.
    /// It takes the text of one that it cannot read there.
    pub fn archived(
        &self,
    ) -> Option<(
        &TargetArchive<'a>,
        Vec<(&NamedTarget<'a>, &'a PackedTarget)>,
    )> {
        let archive = self
            .archive
            .as_ref()
            .filter(|archive| archive.unused.is_none())?;
        let sound = |target| archive.member_of(target).filter(|member| member.is_sound());
        Some((
            archive,
            self.shipped
                .iter()
                .filter_map(|target| Some((target, sound(target)?)))
                .collect(),
        ))
    }

    /// The targets of a group.
    pub fn of_group(&self, group: &str) -> &[usize] {
        self.by_group
            .get(group)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// The place of a target of the system.
    pub(super) fn place(&self, rel: &str) -> Option<usize> {
        self.places.get(rel).copied()
    }

    /// A target by its place.
    pub fn at(&self, place: usize) -> Option<&NamedTarget<'a>> {
        self.shipped.get(place)
    }

    /// The folder of all targets at the top of the data, where it has another name than `targets`,
    /// which is then a word of every group (`docs/loaders/makehuman1/targets.md#names`).
    pub fn renamed_folder(&self) -> Option<&str> {
        let folders: BTreeSet<&str> = self
            .shipped
            .iter()
            .map(|target| target.rel.split_once('/').map_or("", |(top, _)| top))
            .collect();
        let only = folders.first().filter(|_| folders.len() == 1)?;
        // The word `target` is in no group.
        (!matches!(*only, "" | "target" | "targets")).then_some(*only)
    }

    /// Whether there is a group of this name, or one that begins with it and a `-`.
    pub fn has_group_from(&self, name: &str) -> bool {
        let start = format!("{name}-");
        let mut from = self.by_group.range(start.clone()..);
        self.by_group.contains_key(name)
            || from
                .next()
                .is_some_and(|(group, _)| group.starts_with(&start))
    }

    /// The names of all groups.
    pub fn groups(&self) -> impl Iterator<Item = &str> {
        self.by_group.keys().map(String::as_str)
    }
}

/// The groups of texts that are not found.
fn hidden(system: &Layer, found: &BTreeMap<&str, usize>) -> BTreeSet<String> {
    let texts = system
        .files
        .values()
        .filter(|file| file.kind_in(OWN) == Kind::Target && !file.is_loose);
    let lost = texts.filter(|file| !found.contains_key(file.rel.as_str()));
    lost.filter_map(|file| TargetName::of(&file.rel).ok())
        .map(|name| name.group())
        .collect()
}

/// Folders and targets at which the scan stops. What is below a folder with such a name is not told
/// again.
fn clashes(system: &Layer) -> Vec<PathClash<'_>> {
    let is_target = |file: &&FileFacts| file.kind_in(OWN) == Kind::Target && !file.is_loose;
    let folders = system
        .folders
        .iter()
        .chain(&system.hidden_folders)
        .map(|rel| (rel.as_str(), None));
    let files = system
        .files
        .values()
        .filter(is_target)
        .map(|file| (file.rel.as_str(), Some(file)));
    let mut known = BTreeMap::new();
    let mut all: Vec<PathClash<'_>> = Vec::new();
    for (rel, file) in folders.chain(files) {
        let values = values(rel, &known);
        all.extend(values.err().map(|clash| PathClash { rel, file, clash }));
        if file.is_none() {
            known.insert(rel, values);
        }
    }
    let names: BTreeSet<&str> = all.iter().map(|one| one.rel).collect();
    let is_below = |rel: &str| {
        rel.match_indices('/')
            .any(|(end, _)| rel.get(..end).is_some_and(|up| names.contains(up)))
    };
    let below: BTreeSet<&str> = all
        .iter()
        .map(|one| one.rel)
        .filter(|rel| is_below(rel))
        .collect();
    all.into_iter()
        .filter(|one| !below.contains(one.rel))
        .collect()
}

/// The values of a path, from those of the folders above it that are known.
fn values(rel: &str, known: &BTreeMap<&str, Result<Values, Clash>>) -> Result<Values, Clash> {
    let (above, name) = folder_and_name(rel);
    match known.get(above) {
        Some(above) => values_below((*above)?, name),
        None => rel.split('/').try_fold(Values::default(), values_below),
    }
}

/// Whether a path is that of a target that has a slider for itself.
pub fn is_own_target(rel: &str) -> bool {
    (Layout::of(OWN).single)(rel) == Some(Single::OwnTarget)
}

/// The targets in `custom` of the user, each with the name that its path gives it.
fn custom(layers: Layers<'_>) -> Vec<CustomTarget<'_>> {
    let user = layers.user.filter(|_| !layers.is_one_root());
    // Beside the data of a user nobody looks.
    let is_in = |file: &&FileFacts| !file.is_loose || user.is_some_and(|user| user.is_loose);
    let files = user
        .into_iter()
        .flat_map(|user| user.below(CUSTOM))
        .filter(is_in);
    let targets = files.filter(|file| file.kind_in(OWN) == Kind::Target);
    targets
        .map(|file| CustomTarget {
            file,
            name: custom_name(&file.rel),
        })
        .collect()
}

/// `custom/<path with dashes>`.
fn custom_name(rel: &str) -> String {
    let below = rel.strip_prefix("custom/").unwrap_or(rel);
    let stem = below.strip_suffix(".target").unwrap_or(below);
    format!("{CUSTOM}/{}", stem.replace('/', "-"))
}
