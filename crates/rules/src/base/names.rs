//! Names in `base.json` looked up among the sliders: patterns, keys, groups.

use std::collections::BTreeSet;
use std::ops::Bound;

use super::super::cause::component::named_patterns;
use super::super::did_you_mean;
use mhlint_diag::Suggestions;
use mhlint_repo::makehuman2::{Base, View};

/// Beginning of the groups of user targets, which come and go.
const USER: &str = "user";

/// What names are looked up in, gathered once for all of them.
pub(super) struct Names<'n, 'a> {
    pub(super) base: &'n Base<'a>,
    suggestions: &'n Suggestions,
    /// Patterns that components read, if `macro.json` is checked, too: `macro-unknown-pattern`
    /// speaks of them.
    read_by_macros: BTreeSet<String>,
    /// Groups of sliders, and those that an item would show.
    groups: BTreeSet<String>,
    /// What stands before the `|` in them.
    categories: BTreeSet<String>,
    /// The same with the `|`.
    beginnings: Vec<String>,
}

/// A name that does not exist.
pub(super) struct Unknown {
    pub(super) name: String,
    pub(super) message: String,
    pub(super) help: String,
}

impl Unknown {
    fn new(name: &str, message: String, near: Option<&str>, otherwise: &str) -> Self {
        Self {
            name: name.to_owned(),
            message,
            help: did_you_mean(near, otherwise),
        }
    }
}

impl<'n, 'a> Names<'n, 'a> {
    /// The names of a base.
    pub(super) fn of(view: &View<'_>, base: &'n Base<'a>, suggestions: &'n Suggestions) -> Self {
        // A user's sliders over the system's macros are checked against these, too.
        let sliders = base.modelling.winner().map(|(file, _)| file);
        let checked = base.macro_file().filter(|(macros, _)| {
            [sliders, Some(*macros)]
                .into_iter()
                .flatten()
                .any(|file| view.layers.is_checked(file))
        });
        let components = checked.map(|(_, file)| file.components.as_slice());
        let read_by_macros = components
            .unwrap_or_default()
            .iter()
            .flat_map(named_patterns)
            .collect();
        let groups = groups(base);
        let categories: BTreeSet<String> = groups
            .iter()
            .filter_map(|group| group.split('|').next())
            .map(str::to_owned)
            .collect();
        let beginnings = categories
            .iter()
            .map(|category| format!("{category}|"))
            .collect();
        Self {
            base,
            suggestions,
            read_by_macros,
            groups,
            categories,
            beginnings,
        }
    }

    /// A pattern; one that is missing only because its endings are not declared has a finding of
    /// its own.
    pub(super) fn pattern(&self, pattern: &str) -> Option<Unknown> {
        let base = self.base;
        if base.slider(pattern).is_some()
            || base.explains_pattern(pattern)
            || self.read_by_macros.contains(pattern)
        {
            return None;
        }
        let patterns = self
            .base
            .sliders
            .iter()
            .flat_map(|slider| slider.pattern.names())
            .map(String::as_str);
        let message = format!("no slider has the pattern `{pattern}`");
        let near = self.suggestions.nearest(pattern, patterns);
        let mut unknown = Unknown::new(
            pattern,
            message,
            near,
            "use the pattern of a slider, or remove the line",
        );
        let of_key = self.base.entry(pattern);
        if let Some(own) = of_key.and_then(|slider| slider.pattern.names().first()) {
            unknown.help = format!("write the pattern `{own}` instead of the key");
        }
        Some(unknown)
    }

    /// A key of `modelling.json`.
    pub(super) fn entry(&self, key: &str) -> Option<Unknown> {
        if self.base.has_unreadable_entry(key) {
            return None;
        }
        if self.base.entry(key).is_some() {
            return None;
        }
        let keys = self
            .base
            .sliders
            .iter()
            .map(|slider| slider.slider.key.as_str());
        let message = format!("modelling.json has no entry `{key}`");
        let mut unknown = Unknown::new(
            key,
            message,
            self.suggestions.nearest(key, keys),
            "use the key of an entry in modelling.json",
        );
        if let Some(slider) = self.base.slider(key) {
            unknown.help = format!(
                "write the key `{}` instead of the pattern",
                slider.slider.key
            );
        }
        Some(unknown)
    }

    /// A category or group that the randomizer may choose.
    pub(super) fn group(&self, group: &str) -> Option<Unknown> {
        let Self {
            groups, categories, ..
        } = self;
        let known = groups.contains(group) || categories.contains(group);
        if known || group.split('|').next() == Some(USER) {
            return None;
        }
        let near = if group.contains('|') {
            self.suggestions
                .nearest(group, groups.iter().map(String::as_str))
        } else {
            self.suggestions
                .nearest(group, categories.iter().map(String::as_str))
        };
        let message = format!("no slider belongs to the random group `{group}`");
        Some(Unknown::new(
            group,
            message,
            near,
            "use a category or group of the sliders, or remove the line",
        ))
    }

    /// The beginning of a group.
    pub(super) fn head(&self, beginning: &str) -> Option<Unknown> {
        let Self {
            groups, beginnings, ..
        } = self;
        let is_user = beginning.split('|').next() == Some(USER);
        // Of all that come no earlier, those that begin so are the first.
        let first = groups
            .range::<str, _>((Bound::Included(beginning), Bound::Unbounded))
            .next();
        if is_user || first.is_some_and(|group| group.starts_with(beginning)) {
            return None;
        }
        let near = self.suggestions.nearest(
            beginning,
            groups.iter().chain(beginnings).map(String::as_str),
        );
        let message = format!("no slider group begins with `{beginning}`");
        Some(Unknown::new(
            beginning,
            message,
            near,
            "use the beginning of a slider group, or remove the line",
        ))
    }
}

/// Groups of sliders, and those that an item would show: an empty item is a finding of its own.
fn groups(base: &Base<'_>) -> BTreeSet<String> {
    let own = base
        .sliders
        .iter()
        .filter_map(|slider| slider.as_meant().group.clone());
    let categories = [base.categories.winner(), base.user_categories.accepted()];
    let categories = categories
        .into_iter()
        .flatten()
        .flat_map(|(_, model)| &model.categories);
    let shown = categories.flat_map(|category| {
        category
            .items
            .iter()
            .filter_map(|item| category.group_of(item))
    });
    own.chain(shown).collect()
}
