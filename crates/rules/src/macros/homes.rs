//! Where a name belongs that a macro definition lists and cannot generate.

use std::collections::BTreeSet;

use super::space::Space;
use mhlint_formats::macro_json::{MacroFile, Macrodef};

/// The definitions whose components can be told; of those with the same components the first.
pub(super) struct Homes<'a>(Vec<(&'a Macrodef, Space<'a>)>);

impl<'a> Homes<'a> {
    pub(super) fn of(macros: &'a MacroFile) -> Self {
        let mut seen: BTreeSet<&[String]> = BTreeSet::new();
        let first = macros
            .macrodefs
            .iter()
            .filter(|macrodef| seen.insert(&macrodef.components));
        Self(
            first
                .filter_map(|macrodef| Some((macrodef, Space::of(macros, macrodef)?)))
                .collect(),
        )
    }

    /// A definition that generates the name and has other components than `own`.
    pub(super) fn of_name(&self, name: &str, own: &Macrodef) -> Option<&'a Macrodef> {
        let mut others = self
            .0
            .iter()
            .filter(|(other, _)| other.components != own.components);
        others
            .find(|(_, space)| space.parse(name).is_some())
            .map(|(other, _)| *other)
    }
}
