//! The parts of the macro settings with the targets that MPFB composes of their names
//! (`docs/loaders/mpfb/macros.md#the-five-loops`).

use std::collections::{BTreeMap, BTreeSet};

use super::loops::{Axis, LOOPS, Name, are_too_many, is_reachable};
use crate::{FileFacts, Layer};
use mhlint_formats::macro_parts::{MacroParts, RACES, Setting};
use mhlint_source::{normalized, parent};

/// `macro.json` in its layer.
#[derive(Debug)]
pub struct Parts<'a> {
    /// Where it lies.
    pub layer: &'a Layer,
    /// Its file.
    pub file: &'a FileFacts,
    /// What is in it.
    pub settings: &'a MacroParts,
    /// Targets that the loops ask for. None where something is absent that every character needs.
    pub requests: Vec<Request<'a>>,
    /// Whether these are more than are looked at, so that they are left out.
    pub is_too_large: bool,
    /// Printed paths of those that are there.
    found: BTreeSet<&'a str>,
    /// Folders in which sliders lead to one that is not there, in small letters.
    lacking: BTreeSet<String>,
    /// The names that are written for settings, by place.
    names: BTreeSet<(usize, &'a str)>,
    /// For the place of each setting that could be read as a whole where its parts begin, in order,
    /// each with the farthest end of those up to it.
    reach: BTreeMap<usize, Vec<(f64, f64)>>,
}

/// A target that a loop asks for.
#[derive(Debug, Clone)]
pub struct Request<'a> {
    /// Number of the loop.
    pub number: usize,
    /// Numbers of its names, one an axis of the loop.
    pub names: Vec<usize>,
    /// Path below the targets without suffix.
    pub target: String,
    /// Path relative to the data root.
    pub rel: String,
    /// Whether sliders lead to it.
    pub is_reachable: bool,
    /// The target, if it is there.
    pub file: Option<&'a FileFacts>,
}

impl<'a> Parts<'a> {
    pub(super) fn of(layer: &'a Layer, file: &'a FileFacts) -> Option<Self> {
        let settings = file.macro_parts()?;
        let is_too_large = are_too_many(settings);
        let whole = settings.settings.iter().filter(|own| own.is_whole);
        let mut parts = Self {
            layer,
            file,
            settings,
            requests: Vec::new(),
            is_too_large,
            found: BTreeSet::new(),
            lacking: BTreeSet::new(),
            names: names_of(settings).collect(),
            reach: whole.map(|own| (own.place, reach(own))).collect(),
        };
        if settings.is_whole() && !is_too_large {
            parts.requests = parts.all_requests();
            parts.found = parts
                .requests
                .iter()
                .filter_map(|own| Some(own.file?.path.as_str()))
                .collect();
            let missing = parts
                .requests
                .iter()
                .filter(|own| own.is_reachable && own.file.is_none());
            parts.lacking = missing
                .map(|own| parent(&own.rel).to_ascii_lowercase())
                .collect();
        }
        Some(parts)
    }

    /// Whether one of the loops asks for a file.
    pub fn asks_for(&self, file: &FileFacts) -> bool {
        self.found.contains(file.path.as_str())
    }

    /// The word in the name of a target that keeps the loops from asking for it, and the place of
    /// the setting that lacks this name. `None` for a name that is not like those of a loop, and
    /// for a setting without parts.
    pub fn unknown_word<'r>(&self, rel: &'r str) -> Option<(usize, &'r str)> {
        let name = rel
            .strip_prefix(self.folder())?
            .strip_prefix('/')?
            .strip_suffix(".target.gz")?;
        LOOPS.iter().find_map(|own| {
            let words: Vec<&str> = name.strip_prefix(own.prefix)?.split('-').collect();
            let mut unknown = own
                .axes
                .iter()
                .zip(&words)
                .filter(|(axis, word)| !self.has_name(axis, word));
            match (unknown.next(), unknown.next()) {
                (Some((Axis::Setting(place), word)), None) if words.len() == own.axes.len() => {
                    Some((*place, *word))
                }
                _ => None,
            }
        })
    }

    /// Whether a name is written for an axis, in a part that has values or in another.
    fn has_name(&self, axis: &Axis, name: &str) -> bool {
        match axis {
            Axis::Race => RACES.contains(&name),
            Axis::Only(_, only) => *only == name,
            Axis::Setting(place) => {
                let setting = self
                    .settings
                    .settings
                    .iter()
                    .find(|setting| setting.place == *place);
                setting.is_none_or(|setting| setting.parts.is_empty())
                    || self.names.contains(&(*place, name))
            }
        }
    }

    /// Whether some part of a setting has a value; `None` where not all of them could be read.
    pub(super) fn cover(&self, place: usize, value: f64) -> Option<bool> {
        self.reach.get(&place).map(|reach| holds(reach, value))
    }

    /// Whether a loop misses a target in the folder of this one, which may be the one that it is
    /// meant to be.
    pub fn may_be_meant(&self, rel: &str) -> bool {
        self.lacking.contains(&parent(rel).to_ascii_lowercase())
    }

    /// The folder of all targets: the one above that of the file.
    pub fn folder(&self) -> &'a str {
        parent(parent(&self.file.rel))
    }

    fn all_requests(&self) -> Vec<Request<'a>> {
        let mut requests = Vec::new();
        for (number, own) in LOOPS.iter().enumerate() {
            for names in combinations(&own.names(self.settings)) {
                let words: Vec<&str> = names.iter().map(|(_, name)| name.text).collect();
                let Some(target) = own.target(&words) else {
                    continue;
                };
                let path = format!("{}/{target}.target.gz", self.folder());
                // Nothing is found outside of the data.
                let rel = normalized(&path).unwrap_or(path);
                let is_reachable =
                    is_reachable(&names.iter().map(|(_, name)| *name).collect::<Vec<_>>());
                let names = names.iter().map(|(place, _)| *place).collect();
                let file = self.layer.file(&rel);
                requests.push(Request {
                    number,
                    names,
                    target,
                    rel,
                    is_reachable,
                    file,
                });
            }
        }
        requests
    }
}

/// The names that are written for each setting, by its place.
fn names_of(settings: &MacroParts) -> impl Iterator<Item = (usize, &str)> {
    settings.settings.iter().flat_map(|setting| {
        let names = setting
            .parts
            .iter()
            .flat_map(|part| [&part.low, &part.high]);
        names.filter_map(|name| Some((setting.place, name.as_deref()?)))
    })
}

/// Where the parts of a setting begin, in order, each with the farthest end of those up to it.
fn reach(setting: &Setting) -> Vec<(f64, f64)> {
    let ranges = setting.parts.iter().map(|part| (part.lowest, part.highest));
    // A range without numbers has no value.
    let mut ranges: Vec<(f64, f64)> = ranges
        .filter(|(lowest, highest)| lowest < highest)
        .collect();
    ranges.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut farthest = f64::NEG_INFINITY;
    for (_, highest) in &mut ranges {
        farthest = farthest.max(*highest);
        *highest = farthest;
    }
    ranges
}

fn holds(reach: &[(f64, f64)], value: f64) -> bool {
    let count = reach.partition_point(|(lowest, _)| *lowest < value);
    let last = count.checked_sub(1).and_then(|last| reach.get(last));
    last.is_some_and(|(_, farthest)| value < *farthest)
}

/// Every choice of one name from each list, the last list running fastest.
fn combinations<'n, 'p>(
    lists: &'n [Vec<Name<'p>>],
) -> impl Iterator<Item = Vec<(usize, Name<'p>)>> + use<'n, 'p> {
    let count: usize = lists.iter().map(Vec::len).product();
    (0..count).map(|number| {
        let mut rest = number;
        let mut chosen = Vec::with_capacity(lists.len());
        for list in lists.iter().rev() {
            let place = rest % list.len().max(1);
            rest /= list.len().max(1);
            chosen.extend(list.get(place).map(|name| (place, *name)));
        }
        chosen.reverse();
        chosen
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_formats::macro_parts::Part;

    #[test]
    fn a_value_is_covered_by_any_part_that_holds_it() {
        let ranges = [
            (0.5, 0.6),
            (-0.01, 0.4),
            (0.1, 0.2),
            (0.9, 0.8),
            (f64::NAN, 1.0),
        ];
        let parts = ranges.map(|(lowest, highest)| Part {
            lowest,
            highest,
            ..Part::default()
        });
        let setting = Setting {
            parts: parts.to_vec(),
            is_whole: true,
            ..Setting::default()
        };
        let reach = reach(&setting);
        let covered = |value: f64| {
            let held = |(lowest, highest): &(f64, f64)| *lowest < value && value < *highest;
            (holds(&reach, value), ranges.iter().any(held))
        };
        for value in [
            -1.0,
            0.0,
            0.15,
            0.3,
            0.4,
            0.45,
            0.5,
            0.55,
            0.85,
            1.0,
            f64::NAN,
        ] {
            let (found, expected) = covered(value);
            assert_eq!(found, expected, "{value}");
        }
    }
}
