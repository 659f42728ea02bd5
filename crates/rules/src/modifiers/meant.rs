//! Which modifier a name is meant for that none has: the fault may be in the modifier, where it is
//! told.

use std::collections::{BTreeMap, BTreeSet};

use super::super::RuleCx;
use mhlint_diag::{Grouped, grouped};
use mhlint_repo::makehuman1::{KnownModifier, View};
use mhlint_source::first_name;

/// Names that no modifier has, and the modifiers that seem to be meant by them.
pub(crate) struct Meant<'v> {
    /// Modifiers that lack a side or a target, and that no slider sets, by name.
    faulty: BTreeMap<&'v str, &'v KnownModifier<'v>>,
    /// For each of them the slider that seems to mean it.
    sliders: BTreeMap<&'v str, &'v str>,
}

impl<'v> Meant<'v> {
    /// What the sliders mean.
    pub(crate) fn of(view: &'v View<'_>, cx: &RuleCx<'_>) -> Self {
        let with_slider = view.modifiers.with_slider();
        let own = view
            .modifiers
            .all
            .iter()
            .filter(|one| one.modifier.variable.is_none() && is_faulty(one));
        let faulty = own
            .filter(|one| !with_slider.contains(one.name.as_str()))
            .map(|one| (one.name.as_str(), one));
        let mut meant = Self {
            faulty: faulty.collect(),
            sliders: BTreeMap::new(),
        };
        let unknown: BTreeSet<&str> = with_slider
            .into_iter()
            .filter(|name| view.modifiers.called(name).next().is_none())
            .collect();
        for name in unknown {
            if let Some(one) = meant.modifier(name, cx) {
                meant.sliders.entry(&one.name).or_insert(name);
            }
        }
        meant
    }

    /// The modifier at fault that is meant by a name.
    pub(crate) fn modifier(&self, name: &str, cx: &RuleCx<'_>) -> Option<&'v KnownModifier<'v>> {
        if self.faulty.is_empty() {
            return None;
        }
        // One that lacks a side has the name without both.
        let shorter = name
            .rmatch_indices('-')
            .filter_map(|(at, _)| self.faulty.get(name.get(..at)?));
        let lacks_side = shorter
            .into_iter()
            .find(|one| one.modifier.tails.unpaired().is_some())
            .copied();
        lacks_side.or_else(|| {
            let near = cx.suggestions.nearest(name, self.faulty.keys().copied())?;
            self.faulty.get(near).copied()
        })
    }

    /// The slider that means a modifier by another name.
    pub(super) fn slider_for(&self, one: &KnownModifier<'_>) -> Option<&'v str> {
        self.sliders.get(one.name.as_str()).copied()
    }
}

/// The groups of no modifier that several sliders of a file name, with the group of modifiers that
/// seems to be meant.
pub(super) fn meant_groups<'v>(view: &'v View<'_>, cx: &RuleCx<'_>) -> BTreeMap<&'v str, &'v str> {
    let known = KnownGroups::of(view);
    let files = view.modifiers.sets.iter().filter_map(|set| set.sliders);
    let several = files.flat_map(|(_, sliders)| {
        let named = sliders.modifiers().map(|named| group_of(&named.name));
        let lost = grouped(
            named
                .filter(|group| !known.all.contains(group))
                .map(|group| (group, ())),
        );
        lost.into_iter()
            .filter(|(_, all)| all.len() > 1)
            .map(|(group, _)| group)
            .collect::<BTreeSet<_>>()
    });
    several
        .filter_map(|group| Some((group, known.near(group, cx)?)))
        .collect()
}

/// The groups of all modifiers.
pub(super) struct KnownGroups<'v> {
    pub(super) all: BTreeSet<&'v str>,
    in_lower_case: Grouped<String, &'v str>,
}

impl<'v> KnownGroups<'v> {
    pub(super) fn of(view: &'v View<'_>) -> Self {
        let all: BTreeSet<&str> = view.modifiers.names().map(group_of).collect();
        let in_lower_case = grouped(all.iter().map(|group| (group.to_ascii_lowercase(), *group)));
        Self { all, in_lower_case }
    }

    /// The one that is meant by a name of none.
    pub(super) fn near(&self, group: &str, cx: &RuleCx<'_>) -> Option<&'v str> {
        let same = self.in_lower_case.get(&group.to_ascii_lowercase());
        let same = same.and_then(|same| same.first()).copied();
        same.or_else(|| cx.suggestions.nearest(group, self.all.iter().copied()))
    }
}

/// What stands in front of the name of a modifier.
pub(super) fn group_of(name: &str) -> &str {
    first_name(name)
}

/// The name with its sides exchanged.
pub(super) fn exchanged(name: &str) -> Option<String> {
    let (stem, tails) = name.rsplit_once('-')?;
    let (min, max) = tails.split_once('|')?;
    Some(format!("{stem}-{max}|{min}"))
}

/// Whether it has a side alone, or some part without targets.
fn is_faulty(one: &KnownModifier<'_>) -> bool {
    one.modifier.tails.unpaired().is_some() || one.parts.iter().any(|part| part.targets.is_empty())
}
