//! What a macro definition lists, measured against what its components generate.
//!
//! A name that cannot be generated gets the kind of its slip and, where that is clear, the
//! combination it was meant for, so that one misspelt entry is one finding and not a missing
//! combination as well.

use std::collections::{BTreeMap, BTreeSet};

use super::combination_patterns::{digits, is_walkable};
use super::space::{Combination, Space};
use super::spelled::Spelled;
use mhlint_diag::Suggestions;
use mhlint_formats::macro_json::{Link, Macrodef};

/// Strangers beyond this number are not compared with every free name.
const COMPARED: usize = 50;

/// The entries of a definition.
pub(super) struct Listing<'a> {
    /// Combinations with an entry; of several the last.
    pub(super) found: BTreeMap<Combination, &'a Link>,
    /// Entries that no combination spells.
    pub(super) strangers: Vec<Stranger<'a>>,
    /// Combinations whose entry is there but of no use, or meant by a stranger.
    pub(super) claimed: BTreeSet<Combination>,
}

/// An entry whose name is not generated.
pub(super) struct Stranger<'a> {
    pub(super) link: &'a Link,
    pub(super) slip: Slip,
    /// The combination it was probably meant for.
    pub(super) intended: Option<Combination>,
}

/// What is wrong with a name.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Slip {
    /// The right values in the wrong order.
    Order,
    /// One part is no value of its component.
    Value { axis: usize, token: String },
    /// Too many or too few parts.
    Parts(usize),
    /// Anything else.
    Other(String),
}

impl Slip {
    /// A name for what is wrong.
    pub(super) fn word(&self) -> String {
        match self {
            Self::Order => "order".to_owned(),
            Self::Value { token, .. } => format!("value {token}"),
            Self::Parts(count) => format!("parts {count}"),
            Self::Other(text) => format!("other {text}"),
        }
    }

    /// Why a name with this slip is not generated.
    pub(super) fn reason(&self, space: &Space<'_>) -> String {
        let wanted = space.axes.len();
        match self {
            Self::Order => "has its values in a different order from `comp`".to_owned(),
            Self::Value { axis, token } => {
                let name = space.axes.get(*axis).map_or("", |axis| &axis.name);
                match token.as_str() {
                    "" => format!("is never used: it has no value of `{name}`"),
                    token => format!("is never used: `{token}` is not a value of `{name}`"),
                }
            }
            Self::Parts(0) => "is never used: it has no values".to_owned(),
            Self::Parts(1) => format!("is never used: it has 1 part instead of {wanted}"),
            Self::Parts(parts) => {
                format!("is never used: it has {parts} parts instead of {wanted}")
            }
            Self::Other(_) => {
                "is never used: its parts are not values of the components".to_owned()
            }
        }
    }
}

impl<'a> Listing<'a> {
    pub(super) fn of(space: &Space<'_>, macrodef: &'a Macrodef, suggestions: &Suggestions) -> Self {
        let mut found = BTreeMap::new();
        let mut unknown = Vec::new();
        for link in &macrodef.links {
            match space.parse(&link.name) {
                Some(combination) => {
                    found.insert(combination, link);
                }
                None => unknown.push(link),
            }
        }
        let mut claimed: BTreeSet<Combination> = macrodef
            .unusable
            .iter()
            .filter_map(|name| space.parse(name))
            .collect();
        let free = if unknown.is_empty() || unknown.len() > COMPARED {
            Vec::new()
        } else {
            free_names(space, &found)
        };
        let stranger = |link: &'a Link| {
            let (slip, intended) = slip(space, &found, &link.name, suggestions);
            let intended = intended.or_else(|| by_file(space, &found, link));
            let intended = intended.or_else(|| {
                space.parse(suggestions.nearest(&link.name, free.iter().map(String::as_str))?)
            });
            Stranger {
                link,
                slip,
                intended,
            }
        };
        let strangers: Vec<Stranger<'a>> = unknown.into_iter().map(stranger).collect();
        claimed.extend(
            strangers
                .iter()
                .filter_map(|stranger| stranger.intended.clone()),
        );
        Self {
            found,
            strangers,
            claimed,
        }
    }
}

/// The combination that the words of the name spell, and where they leave something open those of
/// the file.
fn by_file(
    space: &Space<'_>,
    found: &BTreeMap<Combination, &Link>,
    link: &Link,
) -> Option<Combination> {
    let file = link.target.as_deref()?.rsplit('/').next()?;
    let combination = Spelled::of(space, &link.name).completed(&Spelled::of(space, file))?;
    (!found.contains_key(&combination)).then_some(combination)
}

/// Names without an entry, if they are few enough to be compared.
fn free_names(space: &Space<'_>, found: &BTreeMap<Combination, &Link>) -> Vec<String> {
    let sizes = space.sizes();
    let Some(size) = space
        .size()
        .filter(|size| *size <= 4096 && is_walkable(&sizes))
    else {
        return Vec::new();
    };
    let all = (0..size).map(|at| digits(&sizes, at));
    all.filter(|combination| !found.contains_key(combination))
        .map(|c| space.name(&c))
        .collect()
}

fn slip(
    space: &Space<'_>,
    found: &BTreeMap<Combination, &Link>,
    name: &str,
    suggestions: &Suggestions,
) -> (Slip, Option<Combination>) {
    let tokens: Vec<&str> = name.split('-').filter(|_| !name.is_empty()).collect();
    if tokens.len() != space.axes.len() {
        return (Slip::Parts(tokens.len()), None);
    }
    if let Some(ordered) = ordered(space, &tokens) {
        return (Slip::Order, Some(ordered));
    }
    let value = |axis: usize, token: &str| {
        space
            .axes
            .get(axis)?
            .values
            .iter()
            .position(|value| value == token)
    };
    let places: Vec<Option<usize>> = tokens
        .iter()
        .enumerate()
        .map(|(axis, token)| value(axis, token))
        .collect();
    let mut foreign = places
        .iter()
        .enumerate()
        .filter(|(_, place)| place.is_none())
        .map(|(axis, _)| axis);
    let (Some(axis), None) = (foreign.next(), foreign.next()) else {
        return (Slip::Other(name.to_owned()), None);
    };
    let token = tokens.get(axis).copied().unwrap_or_default();
    let meant = meant_value(space, found, (axis, token), suggestions);
    let intended = meant.map(|meant| places.iter().map(|place| place.unwrap_or(meant)).collect());
    (
        Slip::Value {
            axis,
            token: token.to_owned(),
        },
        intended,
    )
}

/// The combination with the same values in the order of the components.
fn ordered(space: &Space<'_>, tokens: &[&str]) -> Option<Combination> {
    let mut rest = tokens.to_vec();
    let pick = |axis: &&mhlint_formats::macro_json::Component| {
        let at = rest
            .iter()
            .position(|token| axis.values.iter().any(|value| value == token))?;
        let token = rest.remove(at);
        axis.values.iter().position(|value| value == token)
    };
    space.axes.iter().map(pick).collect()
}

/// The value that a foreign part was meant for: most like it, or the only one of the component
/// without any entry.
fn meant_value(
    space: &Space<'_>,
    found: &BTreeMap<Combination, &Link>,
    (axis, token): (usize, &str),
    suggestions: &Suggestions,
) -> Option<usize> {
    let values = &space.axes.get(axis)?.values;
    if let Some(near) = suggestions.nearest(token, values.iter().map(String::as_str)) {
        return values.iter().position(|value| value == near);
    }
    let used: BTreeSet<usize> = found
        .keys()
        .filter_map(|combination| combination.get(axis).copied())
        .collect();
    let mut unused = (0..values.len()).filter(|value| !used.contains(value));
    let only = unused.next()?;
    unused.next().is_none().then_some(only)
}
