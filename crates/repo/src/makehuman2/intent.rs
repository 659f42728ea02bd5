//! What damaged and misspelt sliders were meant to be. A name that leads nowhere only because of
//! such a slider is no finding: the slider is.

use std::collections::{BTreeMap, BTreeSet};

use super::slider::{Undeclared, as_undeclared};
use super::{Base, BoundSlider, Pattern};
use mhlint_diag::Sought;
use mhlint_formats::modelling::Modelling;

/// Names of missing targets that are compared with others: each pattern that is looked for is
/// compared with all of them.
const COMPARED: usize = 256;

/// What faulty sliders of a base hide.
#[derive(Debug, Default)]
pub(super) struct Intent<'a> {
    /// Whether some slider cannot be read.
    unreadable: bool,
    /// Keys of the entries that are no object.
    no_objects: BTreeSet<&'a str>,
    /// Whether none of the targets that the sliders name is there: they are those of another base.
    foreign: bool,
    /// Whether the icon of some slider cannot be read.
    unreadable_icons: bool,
    /// Targets that entries with misspelt keys, or with a `user` of the system's, were meant to
    /// use.
    targets: BTreeSet<&'a str>,
    /// Patterns of such entries.
    meant: BTreeSet<String>,
    /// Folders of the barycentric sets that are too short.
    short: BTreeSet<Option<String>>,
    /// Patterns of the sliders with two targets that no pair of opposites covers.
    undeclared: BTreeSet<Undeclared<'a>>,
    /// Targets of sliders that lack one.
    lacking: BTreeMap<&'a str, Sought<'a>>,
}

impl<'a> Intent<'a> {
    pub(super) fn of(base: &Base<'a>) -> Self {
        let sliders = || base.sliders.iter();
        let no_objects: BTreeSet<&str> = base
            .models()
            .flat_map(|model| &model.unreadable)
            .map(String::as_str)
            .collect();
        let unreadable = !no_objects.is_empty();
        let has_no_icon = |bound: &BoundSlider<'_>| {
            let slider = bound.slider;
            slider.keys.is_empty() || slider.has("icon") && slider.icon.is_none()
        };
        let misspelt = sliders().filter_map(|bound| bound.slider.meant.as_deref());
        let is_short = |bound: &&BoundSlider<'_>| {
            bound.slider.barycentric.is_some() && bound.slider.barycentric_len < 3
        };
        let short = sliders()
            .filter(is_short)
            .flat_map(|bound| bound.pattern.names());
        let lacking = sliders().filter(|slider| base.lacks_target(slider));
        let names = lacking
            .flat_map(|bound| [&bound.slider.decr, &bound.slider.incr])
            .flatten();
        let marked = || sliders().filter(|bound| base.is_marked_as_users(bound));
        let unmarked = marked()
            .flat_map(|bound| bound.pattern.names())
            .filter_map(|name| name.strip_prefix("custom/"));
        let misspelt = misspelt.chain(marked().map(|bound| bound.slider));
        let foreign = is_foreign(base);
        Self {
            unreadable: unreadable
                || foreign
                || sliders().any(|bound| bound.slider.is_incomplete()),
            no_objects,
            foreign,
            unreadable_icons: unreadable || foreign || sliders().any(has_no_icon),
            targets: misspelt
                .flat_map(|slider| [&slider.incr, &slider.decr])
                .flatten()
                .map(String::as_str)
                .collect(),
            meant: sliders()
                .flat_map(|slider| slider.meant.names())
                .cloned()
                .chain(unmarked.map(str::to_owned))
                .collect(),
            short: short.map(|name| folder_of(name)).collect(),
            undeclared: sliders().flat_map(BoundSlider::undeclared).collect(),
            lacking: names
                .map(|name| (name.as_str(), Sought::new(name)))
                .collect(),
        }
    }
}

/// Sliders of which none finds a target, from this many on, are those of another base.
const FOREIGN: usize = 3;

/// Whether the folder in use has targets, and none of those that the sliders name, in whatever
/// folder or spelling.
fn is_foreign(base: &Base<'_>) -> bool {
    let Some(folder) = base.targets.filter(|_| base.other_targets.is_none()) else {
        return false;
    };
    let has_target =
        |bound: &&BoundSlider<'_>| bound.slider.incr.is_some() || bound.slider.decr.is_some();
    let own = || {
        base.sliders
            .iter()
            .filter(|bound| !bound.slider.user && !bound.slider.is_macro())
            .filter(has_target)
    };
    if own().count() < FOREIGN || !own().all(|bound| base.lacks_target(bound)) {
        return false;
    }
    let stems: BTreeSet<String> = folder
        .targets()
        .map(|file| file.stem().to_lowercase())
        .collect();
    let is_there = |name: &String| {
        let file = name
            .rsplit(['/', '\\'])
            .next()
            .unwrap_or(name)
            .to_lowercase();
        stems.contains(file.strip_suffix(".target").unwrap_or(&file))
    };
    !stems.is_empty()
        && !own()
            .flat_map(|bound| [&bound.slider.incr, &bound.slider.decr])
            .flatten()
            .any(is_there)
}

fn folder_of(pattern: &str) -> Option<String> {
    pattern
        .rsplit_once('/')
        .map(|(folder, _)| folder.to_owned())
}

impl<'a> Base<'a> {
    /// Whether a pattern is missing only because of a slider that has a finding of its own.
    pub fn explains_pattern(&self, pattern: &str) -> bool {
        self.has_unreadable_sliders()
            || self.intent.short.contains(&folder_of(pattern))
            || self.names_undeclared_pair(pattern)
            || self.intent.meant.contains(pattern)
            || self.misspells_target(pattern)
    }

    /// Whether several sliders list the position behind the last macro definition: one was probably
    /// removed, and what it alone used is unused for that reason.
    pub fn lacks_macrodef(&self) -> bool {
        let count = self
            .macro_file()
            .and_then(|(_, macros)| i64::try_from(macros.macrodefs.len()).ok());
        let lists = |slider: &&BoundSlider<'_>| {
            slider
                .slider
                .macro_influence
                .iter()
                .flatten()
                .any(|index| Some(*index) == count)
        };
        count.is_some_and(|count| count > 0) && self.sliders.iter().filter(lists).nth(1).is_some()
    }

    /// Whether some slider cannot be read, so that nobody can tell which patterns, targets and
    /// pictures it would have used.
    pub fn has_unreadable_sliders(&self) -> bool {
        self.intent.unreadable
    }

    /// Whether none of the targets that the sliders name is in the folder in use, which has others.
    pub fn has_foreign_sliders(&self) -> bool {
        self.intent.foreign
    }

    /// Whether an entry of this key is there and no object.
    pub fn has_unreadable_entry(&self, key: &str) -> bool {
        self.intent.no_objects.contains(key)
    }

    /// Whether a picture may be unused only because some slider cannot be read.
    pub fn has_unreadable_icons(&self) -> bool {
        self.intent.unreadable_icons
    }

    /// Whether an entry with a misspelt key was meant to use a target.
    pub fn means_target(&self, name: &str) -> bool {
        self.intent.targets.contains(name)
    }

    fn models(&self) -> impl Iterator<Item = &'a Modelling> + use<'a> {
        let both = self
            .modelling
            .winner()
            .into_iter()
            .chain(self.user_modelling.accepted());
        both.map(|(_, model)| model)
    }

    /// Whether a pattern is missing only because `target-opposites` does not declare its pair.
    fn names_undeclared_pair(&self, pattern: &str) -> bool {
        as_undeclared(pattern).any(|own| self.intent.undeclared.contains(&own))
    }

    /// Whether a slider that names a target which is not there has nearly this pattern.
    fn misspells_target(&self, pattern: &str) -> bool {
        let wanted = pattern.split('|').next().unwrap_or_default();
        let lacking = &self.intent.lacking;
        // Where hundreds are missing, none of them is a slip of the pen.
        lacking.contains_key(wanted)
            || lacking.len() <= COMPARED && lacking.values().any(|own| own.may_mean(wanted))
    }

    /// Whether a target of a slider is not where the application looks for it.
    pub fn lacks_target(&self, bound: &BoundSlider<'_>) -> bool {
        let Some(folder) = self.folder_of(bound) else {
            return false;
        };
        if matches!(bound.pattern, Pattern::Macro(_) | Pattern::Barycentric(_)) {
            return false;
        }
        let packed = |name: &str| {
            let archive = folder.archive().and_then(|file| file.archive());
            archive.is_some_and(|archive| archive.member(name).is_some())
        };
        let mut named = [&bound.slider.incr, &bound.slider.decr]
            .into_iter()
            .flatten();
        named.any(|name| folder.target(name).is_none() && !packed(name))
    }
}
