//! Names of targets and sliders, found by what others come to that differ from them in small ways.

use std::collections::{BTreeMap, BTreeSet};

use super::super::RuleCx;
use mhlint_formats::target::name::category_of;
use mhlint_formats::unfit::NamedAt;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman1::{KnownModifier, View};

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
        let (mut folded, mut joined, mut sliders) =
            (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        for group in view.targets.groups() {
            folded.entry(group.to_ascii_lowercase()).or_insert(group);
            joined.entry(group.replace("--", "-")).or_insert(group);
        }
        for (file, own) in view.modifiers.sets.iter().filter_map(|set| set.sliders) {
            own.modifiers().for_each(|named| {
                sliders.entry(named.name.as_str()).or_insert((file, named));
            });
        }
        Self {
            folded,
            joined,
            sliders,
        }
    }

    /// The first group that differs in capitals or doubled dashes alone.
    pub(super) fn group(&self, group: &str) -> Option<&'v str> {
        let split = group.replace(['_', '.'], "-");
        let folded = self.folded.get(&split.to_ascii_lowercase()).copied();
        folded
            .into_iter()
            .chain(self.joined.get(group).copied())
            .min()
    }
}

/// What to do for a modifier that asks for this group of targets.
pub(super) fn help(
    view: &View<'_>,
    one: &KnownModifier<'_>,
    group: &str,
    spellings: &Spellings<'_>,
    cx: &RuleCx<'_>,
) -> String {
    if let Some(word) = group.split('-').find(|word| category_of(word).is_some()) {
        let category = category_of(word).unwrap_or_default();
        return format!(
            "`{word}` in a name is a value of {category} and in no group: choose another word"
        );
    }
    let near = spellings
        .group(group)
        .or_else(|| cx.suggestions.nearest(group, view.targets.groups()));
    let of_group = near
        .and_then(|near| view.targets.of_group(near).first())
        .and_then(|place| view.targets.at(*place));
    let otherwise = format!("correct `target` of `{}`, or add the target", one.name);
    let Some(target) = of_group else {
        return otherwise;
    };
    let file = &target.file.rel;
    match near.and_then(|near| near.strip_prefix(&one.modifier.group)?.strip_prefix('-')) {
        Some(right) if one.parts.len() == 1 => {
            format!(
                "write `{right}` in `target` for `{file}`, and correct the name in its slider and \
                    description"
            )
        }
        _ => format!("did you mean `{file}`?"),
    }
}

/// What names of groups begin with, as far as another one has words.
pub(super) struct Starts {
    /// By what they are in small letters.
    folded: BTreeMap<String, BTreeSet<String>>,
}

/// The categories that the targets of groups of macros depend on, each with its group.
pub(super) fn categories<'v>(view: &'v View<'_>) -> BTreeSet<(&'v str, &'static str)> {
    let macros = view
        .modifiers
        .all
        .iter()
        .filter(|one| one.modifier.variable.is_some());
    let groups = macros
        .flat_map(|one| &one.parts)
        .map(|part| part.group.as_str());
    let groups: BTreeSet<&str> = groups.collect();
    let targets = groups.into_iter().flat_map(|group| {
        let places = view.targets.of_group(group).iter();
        places.filter_map(move |place| Some((group, view.targets.at(*place)?)))
    });
    targets
        .flat_map(|(group, target)| target.name.categories().map(move |(own, _)| (group, own)))
        .collect()
}

/// Words of a group for which others are looked for that begin like it.
const MOST_WORDS: usize = 32;

impl Starts {
    pub(super) fn of(view: &View<'_>, words: usize) -> Self {
        let mut folded: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for group in view.targets.groups().filter(|_| words <= MOST_WORDS) {
            let start = group.split('-').take(words).collect::<Vec<_>>().join("-");
            folded
                .entry(start.to_ascii_lowercase())
                .or_default()
                .insert(start);
        }
        Self { folded }
    }

    pub(super) fn all(&self) -> impl Iterator<Item = &str> {
        self.folded.values().flatten().map(String::as_str)
    }

    /// The first that differs in capitals or a slash behind it alone.
    pub(super) fn same(&self, group: &str) -> Option<&str> {
        self.folded
            .get(&group.trim_end_matches('/').to_ascii_lowercase())?
            .first()
            .map(String::as_str)
    }
}
