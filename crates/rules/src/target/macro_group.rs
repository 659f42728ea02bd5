//! The targets of a macro of MakeHuman 1, and which of them do not fit the others.

use std::collections::{BTreeMap, BTreeSet};

use mhlint_formats::target::name::CATEGORIES;
use mhlint_repo::makehuman1::{NamedTarget, View};

/// The targets of a macro: those of the group that macro modifiers name.
pub(super) struct MacroGroup<'v> {
    /// The name of the group.
    pub(super) name: &'v str,
    /// Its targets.
    pub(super) targets: Vec<&'v NamedTarget<'v>>,
    /// The categories that most of them depend on, in order.
    pub(super) categories: Vec<&'static str>,
    /// Targets that nothing reads and that seem to be meant for it, each with the word that keeps
    /// it out.
    pub(super) strays: Vec<(&'v NamedTarget<'v>, String)>,
}

/// The macros of a view. None while nobody can tell what its modifiers are, or which targets are
/// found.
pub(super) fn macro_groups<'v>(view: &'v View<'_>) -> Vec<MacroGroup<'v>> {
    // Where the names of folders stop the search no target is found.
    let is_unknown = view.targets.is_packed || !view.targets.clashes.is_empty();
    if !view.layers.checks_system() || is_unknown || !view.modifiers.is_whole() {
        return Vec::new();
    }
    let names: BTreeSet<&str> = view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.variable.is_some())
        .map(|one| one.modifier.group.as_str())
        .collect();
    let groups = names.iter().map(|name| {
        let targets = view
            .targets
            .of_group(name)
            .iter()
            .filter_map(|place| view.targets.at(*place))
            .collect();
        MacroGroup {
            name,
            categories: most(&targets),
            targets,
            strays: Vec::new(),
        }
    });
    let mut groups: Vec<MacroGroup<'v>> = groups.collect();
    let used = &view.modifiers.uses;
    for (place, target) in view.targets.shipped.iter().enumerate() {
        let own = target.name.group();
        if used.contains_key(&place) || !target.name.is_macro() {
            continue;
        }
        // The longest name that it begins with; they are in order.
        let mut begins = own.rmatch_indices('-').filter_map(|(dash, _)| {
            let (begin, rest) = own.split_at(dash);
            let group = groups
                .binary_search_by(|group| group.name.cmp(begin))
                .ok()?;
            Some((group, rest.trim_start_matches('-').to_owned()))
        });
        let longest = begins.next();
        if let Some((group, rest)) = longest
            && let Some(group) = groups.get_mut(group)
        {
            group.strays.push((target, rest));
        }
    }
    groups
}

/// The categories that most targets depend on.
fn most(targets: &Vec<&NamedTarget<'_>>) -> Vec<&'static str> {
    let mut counts: BTreeMap<Vec<&'static str>, usize> = BTreeMap::new();
    for target in targets {
        *counts.entry(categories(target)).or_default() += 1;
    }
    counts
        .into_iter()
        .max_by_key(|(_, count)| *count)
        .map(|(categories, _)| categories)
        .unwrap_or_default()
}

pub(super) fn categories(target: &NamedTarget<'_>) -> Vec<&'static str> {
    target
        .name
        .categories()
        .map(|(category, _)| category)
        .collect()
}

/// Combinations looked at in one group; the largest of the program has 648.
const MOST: usize = 1 << 14;

impl MacroGroup<'_> {
    /// Those that depend on other categories than most.
    pub(super) fn odd(&self) -> impl Iterator<Item = &NamedTarget<'_>> {
        self.targets
            .iter()
            .copied()
            .filter(|target| categories(target) != self.categories)
    }

    /// Combinations of values without a target that none of the targets beside them explains. A
    /// value that never occurs is left out on purpose, and so is a pair of values that never occurs
    /// together (`docs/loaders/makehuman1/targets.md#macro-groups`).
    pub(super) fn holes(&self) -> Vec<Vec<&'static str>> {
        let of = |target: &&NamedTarget<'_>| {
            self.categories
                .iter()
                .filter_map(|category| target.name.value(category))
                .collect::<Vec<_>>()
        };
        let fitting = self
            .targets
            .iter()
            .copied()
            .filter(|target| categories(target) == self.categories);
        let present: BTreeSet<Vec<&'static str>> = fitting.map(|target| of(&target)).collect();
        let pairs: BTreeSet<(&str, &str)> = present
            .iter()
            .flat_map(|values| {
                values
                    .iter()
                    .flat_map(move |one| values.iter().map(move |other| (*one, *other)))
            })
            .collect();
        let values = |category: &&'static str| {
            let all = CATEGORIES
                .iter()
                .find(|(own, _)| own == category)
                .map_or(&[][..], |(_, words)| *words);
            all.iter()
                .copied()
                .filter(|word| pairs.contains(&(*word, *word)))
                .collect::<Vec<_>>()
        };
        let values: Vec<Vec<&'static str>> = self.categories.iter().map(values).collect();
        if values
            .iter()
            .map(Vec::len)
            .try_fold(1_usize, usize::checked_mul)
            .is_none_or(|count| count > MOST)
        {
            return Vec::new();
        }
        let all = values
            .iter()
            .fold(vec![Vec::new()], |begun: Vec<Vec<&'static str>>, words| {
                begun
                    .iter()
                    .flat_map(|start| {
                        words
                            .iter()
                            .map(|word| [start.as_slice(), &[*word]].concat())
                    })
                    .collect()
            });
        let occurs = |values: &Vec<&'static str>| {
            values
                .iter()
                .all(|one| values.iter().all(|other| pairs.contains(&(*one, *other))))
        };
        let mut holes: Vec<Vec<&'static str>> = all
            .into_iter()
            .filter(|values| !present.contains(values) && occurs(values))
            .collect();
        // Each that does not fit was meant for one of them.
        for target in self
            .odd()
            .chain(self.strays.iter().map(|(target, _)| *target))
        {
            let fits = |hole: &Vec<&'static str>| {
                target
                    .name
                    .categories()
                    .all(|(_, value)| hole.contains(&value))
            };
            if let Some(place) = holes.iter().position(fits) {
                holes.remove(place);
            }
        }
        holes
    }
}
