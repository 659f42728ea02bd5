//! What damaged and misspelt sliders were meant to be. A name that leads nowhere only because of such a slider is
//! no finding: the slider is.

use super::{Base, BoundSlider, Pattern};
use crate::diag::nearest;
use crate::formats::modelling::Modelling;

impl<'a> Base<'a> {
    /// Whether a pattern is missing only because of a slider that has a finding of its own.
    pub fn explains_pattern(&self, pattern: &str) -> bool {
        self.has_unreadable_sliders()
            || self.misses_in_barycentric(pattern)
            || self.names_undeclared_pair(pattern)
            || self.sliders.iter().any(|slider| slider.meant.names().iter().any(|name| name == pattern))
            || self.misspells_target(pattern)
    }

    /// Whether several sliders list the position behind the last macro definition: one was probably removed, and what
    /// it alone used is unused for that reason.
    pub fn lacks_macrodef(&self) -> bool {
        let count = self.macro_file().and_then(|(_, macros)| i64::try_from(macros.macrodefs.len()).ok());
        let lists = |slider: &&BoundSlider<'_>| {
            slider.slider.macro_influence.iter().flatten().any(|index| Some(*index) == count)
        };
        count.is_some_and(|count| count > 0) && self.sliders.iter().filter(lists).nth(1).is_some()
    }

    /// Whether some slider cannot be read, so that nobody can tell which patterns, targets and pictures it
    /// would have used.
    pub fn has_unreadable_sliders(&self) -> bool {
        self.models().any(|model| !model.unreadable.is_empty())
            || self.sliders.iter().any(|slider| slider.slider.is_incomplete())
    }

    /// Whether an entry of this key is there and no object.
    pub fn has_unreadable_entry(&self, key: &str) -> bool {
        self.models().any(|model| model.unreadable.iter().any(|other| other == key))
    }

    /// Whether a picture may be unused only because some slider cannot be read.
    pub fn has_unreadable_icons(&self) -> bool {
        let lost = |bound: &BoundSlider<'_>| {
            let slider = bound.slider;
            slider.keys.is_empty() || slider.has("icon") && slider.icon.is_none()
        };
        self.models().any(|model| !model.unreadable.is_empty()) || self.sliders.iter().any(lost)
    }

    /// Whether an entry with a misspelt key was meant to use a target.
    pub fn means_target(&self, name: &str) -> bool {
        let meant = self.sliders.iter().filter_map(|slider| slider.slider.meant.as_deref());
        meant.into_iter().any(|slider| [&slider.incr, &slider.decr].into_iter().flatten().any(|own| own == name))
    }

    fn models(&self) -> impl Iterator<Item = &'a Modelling> + use<'a> {
        let both = self.modelling.winner().into_iter().chain(self.user_modelling.accepted());
        both.map(|(_, model)| model)
    }

    /// Whether a pattern may be missing only because a barycentric set of its folder is too short.
    fn misses_in_barycentric(&self, pattern: &str) -> bool {
        let folder = |pattern: &str| pattern.rsplit_once('/').map(|(folder, _)| folder.to_owned());
        self.sliders.iter().any(|bound| {
            let short = bound.slider.barycentric.is_some() && bound.slider.barycentric_len < 3;
            short && bound.pattern.names().iter().any(|name| folder(name) == folder(pattern))
        })
    }

    /// Whether a pattern is missing only because `target-opposites` does not declare its pair.
    fn names_undeclared_pair(&self, pattern: &str) -> bool {
        self.sliders.iter().any(|slider| slider.would_register(pattern))
    }

    /// Whether a slider that names a target which is not there has nearly this pattern.
    fn misspells_target(&self, pattern: &str) -> bool {
        let strip = |text: &str| text.split('|').next().unwrap_or_default().to_owned();
        let wanted = strip(pattern);
        self.sliders.iter().filter(|slider| self.lacks_target(slider)).any(|slider| {
            let own = [&slider.slider.decr, &slider.slider.incr].into_iter().flatten();
            own.into_iter().any(|own| *own == wanted || nearest(own, [wanted.as_str()]).is_some())
        })
    }

    /// Whether a target of a slider is not where the application looks for it.
    pub fn lacks_target(&self, bound: &BoundSlider<'_>) -> bool {
        let Some(folder) = self.folder_of(bound) else { return false };
        if matches!(bound.pattern, Pattern::Macro(_) | Pattern::Barycentric(_)) {
            return false;
        }
        let packed = |name: &str| {
            let archive = folder.archive().and_then(|file| file.archive());
            archive.is_some_and(|archive| archive.member(name).is_some())
        };
        let mut named = [&bound.slider.incr, &bound.slider.decr].into_iter().flatten();
        named.any(|name| folder.target(name).is_none() && !packed(name))
    }
}
