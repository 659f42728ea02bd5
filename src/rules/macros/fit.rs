//! Which combination a target file was made for, told by the values that its name spells.
//!
//! File names are free; by habit they are the values of a combination, with those left out that make no difference.

use std::collections::BTreeSet;

use super::links::has_suffix;
use crate::formats::macro_json::{MacroFile, Macrodef};

/// The parts of a name.
pub(super) fn values_of(name: &str) -> BTreeSet<&str> {
    if has_suffix(name) { BTreeSet::new() } else { name.split('-').collect() }
}

/// Whether a file that spells some values is right for a combination: it spells nothing else.
pub(super) fn fits(file: &BTreeSet<&str>, name: &BTreeSet<&str>) -> bool {
    !file.is_empty() && file.is_subset(name)
}

/// Listed names of some definitions that a file fits, those only that leave the fewest values open.
pub(super) fn fitting_names<'s>(macrodefs: &[&'s Macrodef], file: &BTreeSet<&str>) -> Vec<&'s str> {
    let links = macrodefs.iter().flat_map(|macrodef| &macrodef.links);
    let names = links.map(|link| (values_of(&link.name), link.name.as_str()));
    let fitting: Vec<(usize, &str)> =
        names.filter(|(values, _)| fits(file, values)).map(|(values, name)| (values.len(), name)).collect();
    let best = fitting.iter().map(|(values, _)| *values).min();
    fitting.into_iter().filter(|(values, _)| Some(*values) == best).map(|(_, name)| name).collect()
}

/// A component of which a file spells another value than the combination: the value in the file, the one in the name.
pub(super) fn contradiction<'s>(
    macros: &'s MacroFile,
    macrodef: &Macrodef,
    name: &str,
    file: &BTreeSet<&str>,
) -> Option<(&'s str, &'s str)> {
    let name = values_of(name);
    let axes = macros.components.iter().filter(|component| macrodef.components.contains(&component.name));
    let mut found = axes.filter_map(|axis| {
        let meant = axis.values.iter().find(|value| name.contains(value.as_str()))?;
        let spelt = axis.values.iter().find(|value| file.contains(value.as_str()))?;
        (spelt != meant && !file.contains(meant.as_str())).then_some((spelt.as_str(), meant.as_str()))
    });
    found.next()
}
