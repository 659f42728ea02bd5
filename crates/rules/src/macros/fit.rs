//! Which combination a target file was made for, told by the values that its name spells.
//!
//! File names are free; by habit they are the values of a combination, with those left out that
//! make no difference.

use std::cell::Cell;
use std::collections::BTreeSet;

use super::links::has_suffix;
use mhlint_diag::{Grouped, grouped};
use mhlint_formats::macro_json::{MacroFile, Macrodef};

/// The parts of a name.
pub(super) fn values_of(name: &str) -> BTreeSet<&str> {
    if has_suffix(name) {
        BTreeSet::new()
    } else {
        name.split('-').collect()
    }
}

/// Whether a file that spells some values is right for a combination: it spells nothing else.
fn fits(file: &BTreeSet<&str>, name: &BTreeSet<&str>) -> bool {
    !file.is_empty() && file.is_subset(name)
}

/// Values that are compared at most, for all questions to some spellings: a tenth of a second. Then
/// nothing fits any more.
const COMPARED: usize = 1 << 22;

/// Names of files or of combinations, each with what it belongs to, found by the values that they
/// spell.
pub(super) struct Spellings<'s, T> {
    all: Vec<(BTreeSet<&'s str>, T)>,
    by_value: Grouped<&'s str, usize>,
    compared: Cell<usize>,
}

impl<'s, T> Spellings<'s, T> {
    pub(super) fn of(names: impl Iterator<Item = (&'s str, T)>) -> Self {
        let all: Vec<(BTreeSet<&str>, T)> = names.map(|(name, of)| (values_of(name), of)).collect();
        let numbered = all.iter().enumerate();
        let values =
            numbered.flat_map(|(at, (values, _))| values.iter().map(move |value| (*value, at)));
        let by_value = grouped(values);
        Self {
            all,
            by_value,
            compared: Cell::new(0),
        }
    }

    /// The combinations among them that a file is right for, in their order.
    pub(super) fn fitted_by(&self, file: &BTreeSet<&str>) -> Vec<&(BTreeSet<&'s str>, T)> {
        let holding = file.iter().map(|value| {
            self.by_value
                .get(value)
                .map(Vec::as_slice)
                .unwrap_or_default()
        });
        // Whatever spells all of the values spells the rarest of them.
        let rarest = holding
            .min_by_key(|holding| holding.len())
            .unwrap_or_default();
        rarest
            .iter()
            .filter_map(|at| self.all.get(*at))
            .filter(|(name, _)| self.compare(file, name))
            .collect()
    }

    /// The files among them that are right for a combination, in their order.
    pub(super) fn fitting(&self, name: &BTreeSet<&str>) -> Vec<&(BTreeSet<&'s str>, T)> {
        let holding = name
            .iter()
            .filter_map(|value| Some((value, self.by_value.get(value)?)));
        // Each file is asked for once, with the first value that it spells.
        let begins = |value: &str, at: &usize| {
            self.all
                .get(*at)
                .is_some_and(|(file, _)| file.first() == Some(&value))
        };
        let mut found: Vec<usize> = holding
            .flat_map(|(value, holding)| {
                holding.iter().copied().filter(move |at| begins(value, at))
            })
            .filter(|at| {
                self.all
                    .get(*at)
                    .is_some_and(|(file, _)| self.compare(file, name))
            })
            .collect();
        found.sort_unstable();
        found
            .into_iter()
            .filter_map(|at| self.all.get(at))
            .collect()
    }

    fn compare(&self, file: &BTreeSet<&str>, name: &BTreeSet<&str>) -> bool {
        self.compared
            .set(self.compared.get().saturating_add(file.len() + name.len()));
        self.compared.get() <= COMPARED && fits(file, name)
    }
}

/// The names listed by some definitions.
pub(super) fn listed_names(macrodefs: &[Macrodef]) -> Spellings<'_, (usize, &str)> {
    let links = macrodefs
        .iter()
        .flat_map(|macrodef| macrodef.links.iter().map(|link| (macrodef.index, link)));
    Spellings::of(links.map(|(index, link)| (link.name.as_str(), (index, link.name.as_str()))))
}

/// Listed names of some definitions that a file fits, those only that leave the fewest values open.
pub(super) fn fitting_names<'s>(
    listed: &Spellings<'s, (usize, &'s str)>,
    macrodefs: &[&Macrodef],
    file: &BTreeSet<&str>,
) -> Vec<&'s str> {
    let own: BTreeSet<usize> = macrodefs.iter().map(|macrodef| macrodef.index).collect();
    let fitting: Vec<(usize, &str)> = listed
        .fitted_by(file)
        .into_iter()
        .filter(|(_, (index, _))| own.contains(index))
        .map(|(values, (_, name))| (values.len(), *name))
        .collect();
    let best = fitting.iter().map(|(values, _)| *values).min();
    fitting
        .into_iter()
        .filter(|(values, _)| Some(*values) == best)
        .map(|(_, name)| name)
        .collect()
}

/// A component of which a file spells another value than the combination: the value in the file,
/// the one in the name.
pub(super) fn contradiction<'s>(
    macros: &'s MacroFile,
    macrodef: &Macrodef,
    name: &str,
    file: &BTreeSet<&str>,
) -> Option<(&'s str, &'s str)> {
    let name = values_of(name);
    let axes = macros
        .components
        .iter()
        .filter(|component| macrodef.components.contains(&component.name));
    let mut found = axes.filter_map(|axis| {
        let meant = axis
            .values
            .iter()
            .find(|value| name.contains(value.as_str()))?;
        let spelt = axis
            .values
            .iter()
            .find(|value| file.contains(value.as_str()))?;
        (spelt != meant && !file.contains(meant.as_str()))
            .then_some((spelt.as_str(), meant.as_str()))
    });
    found.next()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spellings<'s>(names: &[&'s str]) -> Spellings<'s, &'s str> {
        Spellings::of(names.iter().map(|name| (*name, *name)))
    }

    #[test]
    fn files_and_combinations_find_each_other_by_their_values() {
        let combinations = spellings(&["male-young-thin", "male-old-thin", "female-young-thin"]);
        let fitted = |file| {
            combinations
                .fitted_by(&values_of(file))
                .into_iter()
                .map(|(_, name)| *name)
                .collect::<Vec<_>>()
        };
        assert_eq!(fitted("male-thin"), ["male-young-thin", "male-old-thin"]);
        assert_eq!(fitted("male-fat"), [""; 0]);
        assert_eq!(fitted("x.target"), [""; 0]);
        let files = spellings(&["young", "male-fat", "thin-male", "x.target"]);
        let fitting: Vec<_> = files
            .fitting(&values_of("male-young-thin"))
            .into_iter()
            .map(|(_, file)| *file)
            .collect();
        assert_eq!(fitting, ["young", "thin-male"]);
    }

    #[test]
    fn strangers_are_not_compared_and_crowds_only_so_often() {
        let names: Vec<String> = (0..4000).map(|at| format!("n{at}-x")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let listed = spellings(&names);
        let strangers =
            (0..2000).filter(|at| !listed.fitted_by(&values_of(&format!("n{at}-y"))).is_empty());
        assert_eq!(strangers.count(), 0);
        assert_eq!(listed.compared.get(), 0);
        let all = (0..2000).filter(|_| listed.fitted_by(&values_of("x")).len() == names.len());
        assert_eq!(all.count(), COMPARED / 3 / names.len());
    }
}
