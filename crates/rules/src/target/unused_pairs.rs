//! Unused targets that are opposites: of one another, or of the one target of a slider.

use std::collections::{BTreeMap, BTreeSet};

use super::endings::Endings;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::Base;

/// What a base says of opposites.
pub(super) struct Pairing<'b> {
    endings: Endings<'b>,
    /// Keys of the sliders without `decr`, by what they have as `incr`; of several the first.
    without_decr: BTreeMap<&'b str, &'b str>,
}

impl<'b> Pairing<'b> {
    pub(super) fn of(base: &'b Base<'_>) -> Self {
        let sliders = base
            .sliders
            .iter()
            .rev()
            .map(|bound| bound.slider)
            .filter(|slider| slider.decr.is_none());
        let without_decr = sliders
            .filter_map(|slider| Some((slider.incr.as_deref()?, slider.key.as_str())))
            .collect();
        Self {
            endings: Endings::of(base, None),
            without_decr,
        }
    }

    /// Each target, and the two of a pair of opposites as one, the increasing one first: a slider
    /// that is gone leaves both.
    pub(super) fn of_files<'a>(
        &self,
        files: &[&'a FileFacts],
    ) -> Vec<(&'a FileFacts, Option<&'a FileFacts>)> {
        // What each stem would be the increasing one for; the first pair of endings counts.
        let mut decrs: BTreeMap<String, (usize, &'a FileFacts)> = BTreeMap::new();
        for file in files {
            for (place, incr) in self.endings.increasing(file.stem()) {
                let first = decrs.entry(incr).or_insert((place, file));
                if place < first.0 {
                    *first = (place, file);
                }
            }
        }
        let decr_of = |file: &FileFacts| decrs.get(file.stem()).map(|(_, decr)| *decr);
        let pairs: Vec<_> = files.iter().map(|file| (*file, decr_of(file))).collect();
        let told: BTreeSet<&str> = pairs
            .iter()
            .filter_map(|(_, decr)| Some(decr.as_ref()?.path.as_str()))
            .collect();
        pairs
            .iter()
            .copied()
            .filter(|(file, _)| !told.contains(file.path.as_str()))
            .collect()
    }

    /// The slider that has the opposite of a target and lacks the target itself.
    pub(super) fn slider_without(&self, decr: &str) -> Option<&'b str> {
        let known = self
            .endings
            .increasing(decr)
            .filter_map(|(place, incr)| Some((place, *self.without_decr.get(incr.as_str())?)));
        known.min().map(|(_, key)| key)
    }
}
