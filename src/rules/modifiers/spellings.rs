//! Names of targets and sliders, found by what others come to that differ from them in small ways.

use std::collections::BTreeMap;

use crate::formats::unfit::NamedAt;
use crate::repo::FileFacts;
use crate::repo::makehuman1::View;

/// Names that others may be meant for, found by what they come to.
pub(super) struct Spellings<'v> {
    /// Groups of targets in small letters.
    folded: BTreeMap<String, &'v str>,
    /// The same with one dash where there are two.
    joined: BTreeMap<String, &'v str>,
    /// What sliders set, with the first of each name.
    pub(super) sliders: BTreeMap<&'v str, (&'v FileFacts, &'v NamedAt)>,
}

impl<'v> Spellings<'v> {
    pub(super) fn of(view: &'v View<'_>) -> Self {
        let (mut folded, mut joined, mut sliders) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        for group in view.targets.groups() {
            folded.entry(group.to_ascii_lowercase()).or_insert(group);
            joined.entry(group.replace("--", "-")).or_insert(group);
        }
        for (file, own) in view.modifiers.sets.iter().filter_map(|set| set.sliders) {
            own.modifiers().for_each(|named| {
                sliders.entry(named.name.as_str()).or_insert((file, named));
            });
        }
        Self { folded, joined, sliders }
    }

    /// The first group that differs in capitals or doubled dashes alone.
    pub(super) fn group(&self, group: &str) -> Option<&'v str> {
        let split = group.replace(['_', '.'], "-");
        let folded = self.folded.get(&split.to_ascii_lowercase()).copied();
        folded.into_iter().chain(self.joined.get(group).copied()).min()
    }
}
