//! A value of a component that no name has, while names have another word in its place.

use std::collections::{BTreeMap, BTreeSet};

use super::holders::Holders;
use super::listing::{Listing, Slip};
use super::sound::sound_space;
use super::space::Space;
use mhlint_diag::Suggestions;
use mhlint_formats::macro_json::{Component, Link, MacroFile, Macrodef};
use mhlint_repo::FileFacts;

/// The value, what the names have instead, and the names with their definitions.
pub(super) struct MisspeltValue<'a> {
    pub(super) component: &'a Component,
    pub(super) value: usize,
    pub(super) token: String,
    pub(super) names: Vec<(&'a Macrodef, &'a Link)>,
}

impl MisspeltValue<'_> {
    pub(super) fn written(&self) -> &str {
        self.component
            .values
            .get(self.value)
            .map_or("", String::as_str)
    }
}

/// Components, and what names have instead of a value of theirs.
pub(super) struct Tokens<'m>(BTreeSet<(&'m str, &'m str)>);

impl<'m> Tokens<'m> {
    pub(super) fn of(values: &'m [MisspeltValue<'_>]) -> Self {
        let both = |value: &'m MisspeltValue<'_>| (&*value.component.name, &*value.token);
        Self(values.iter().map(both).collect())
    }

    /// Whether a name is wrong for this reason.
    pub(super) fn contain(&self, space: &Space<'_>, slip: &Slip) -> bool {
        let Slip::Value { axis, token } = slip else {
            return false;
        };
        let axis = space.axes.get(*axis);
        axis.is_some_and(|axis| self.0.contains(&(axis.name.as_str(), token.as_str())))
    }
}

/// What names have in place of a component's values, and which values they have.
#[derive(Default)]
struct Usage<'a> {
    used: BTreeSet<usize>,
    strange: BTreeMap<String, Vec<(&'a Macrodef, &'a Link)>>,
}

/// All of them. A word in a single name is a slip in that name.
pub(super) fn misspelt_values<'a>(
    file: &FileFacts,
    macros: &'a MacroFile,
    suggestions: &Suggestions,
) -> Vec<MisspeltValue<'a>> {
    let mut usages: BTreeMap<&str, Usage<'a>> = BTreeMap::new();
    for macrodef in &macros.macrodefs {
        let Some(space) = sound_space(file, macros, macrodef) else {
            continue;
        };
        let listing = Listing::of(&space, macrodef, suggestions);
        for (axis, component) in space.axes.iter().enumerate() {
            let usage = usages.entry(&component.name).or_default();
            usage.used.extend(
                listing
                    .found
                    .keys()
                    .filter_map(|combination| combination.get(axis)),
            );
            for stranger in &listing.strangers {
                if let Slip::Value { axis: at, token } = &stranger.slip
                    && *at == axis
                {
                    usage
                        .strange
                        .entry(token.clone())
                        .or_default()
                        .push((macrodef, stranger.link));
                }
            }
        }
    }
    let of_component = |component: &'a Component| {
        Some(of_component(
            component,
            usages.get(component.name.as_str())?,
            suggestions,
        ))
    };
    macros
        .components
        .iter()
        .filter_map(of_component)
        .flatten()
        .collect()
}

fn of_component<'a>(
    component: &'a Component,
    usage: &Usage<'a>,
    suggestions: &Suggestions,
) -> Vec<MisspeltValue<'a>> {
    let values = component.values.iter().enumerate();
    let unused: Vec<&str> = values
        .filter(|(at, _)| !usage.used.contains(at))
        .map(|(_, value)| value.as_str())
        .collect();
    let only = usage.strange.len() == 1 && unused.len() == 1;
    let strange = usage.strange.iter().filter(|(_, names)| names.len() > 1);
    let misspelt = strange.filter_map(|(token, names)| {
        let near = suggestions.nearest(token, unused.iter().copied());
        let meant = near.or_else(|| unused.first().copied().filter(|_| only))?;
        let value = component.values.iter().position(|value| value == meant)?;
        Some(MisspeltValue {
            component,
            value,
            token: token.clone(),
            names: names.clone(),
        })
    });
    misspelt.collect()
}

/// Where no name is right because all have values of another component in one place: that place,
/// and the component.
pub(super) fn other_component<'a>(
    holders: &Holders<'a>,
    listing: &Listing<'_>,
) -> Option<(usize, &'a Component)> {
    let mut tokens: BTreeSet<(usize, &str)> = BTreeSet::new();
    for stranger in &listing.strangers {
        let Slip::Value { axis, token } = &stranger.slip else {
            return None;
        };
        tokens.insert((*axis, token));
    }
    let (axis, _) = *tokens.first()?;
    if !listing.found.is_empty()
        || tokens.len() < 2
        || tokens.iter().any(|(other, _)| *other != axis)
    {
        return None;
    }
    let tokens: Vec<&str> = tokens.iter().map(|(_, token)| *token).collect();
    Some((axis, holders.of_all(&tokens).next()?))
}
