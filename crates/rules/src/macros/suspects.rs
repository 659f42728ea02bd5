//! Entries of `macro.json` that name a file of other values while a better one is free.

use std::collections::BTreeSet;

use super::fit::{Spellings, contradiction, values_of};
use super::links::{MacroLink, links};
use mhlint_diag::{Grouped, grouped};
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::{Base, View};

/// An entry that names another value's file although a better one is free.
pub(super) struct Suspect<'s> {
    pub(super) link: MacroLink<'s>,
    pub(super) better: &'s FileFacts,
    /// The value that `t` spells, and the one that the name has.
    pub(super) values: (&'s str, &'s str),
}

/// Entries that name one file against their names, from this many on, have one fault between them:
/// the file was written to all of them.
const CROWD: usize = 4;

/// Suspects by the definition and the file that they name.
pub(super) fn by_file<'a>(
    suspects: &'a [Suspect<'_>],
) -> Grouped<(usize, &'a str), &'a Suspect<'a>> {
    let file = |suspect: &Suspect<'a>| (suspect.link.macrodef.index, suspect.link.reference.text);
    grouped(suspects.iter().map(|suspect| (file(suspect), suspect)))
}

/// Whether these suspects have one fault between them.
pub(super) fn is_crowd(suspects: &[&Suspect<'_>]) -> bool {
    suspects.len() >= CROWD
}

/// All suspects; `free` are the unused files of the macro folders.
pub(super) fn suspects<'s>(
    view: &'s View<'_>,
    base: &'s Base<'_>,
    free: &[&'s FileFacts],
) -> Vec<Suspect<'s>> {
    let Some((_, macros)) = base.macro_file() else {
        return Vec::new();
    };
    let all = links(view, base);
    let free = Spellings::of(free.iter().map(|file| (file.stem(), *file)));
    let found = all.iter().filter_map(|link| Some((link, link.found()?)));
    found
        .filter_map(|(link, file)| {
            let values = contradiction(
                macros,
                link.macrodef,
                &link.link.name,
                &values_of(file.stem()),
            )?;
            let folder = file.rel.rsplit_once('/')?.0;
            let fitting = free.fitting(&values_of(&link.link.name));
            let beside = |other: &FileFacts| {
                other
                    .rel
                    .rsplit_once('/')
                    .is_some_and(|(parent, _)| parent == folder)
            };
            let better = |(spelt, other): &&(BTreeSet<&str>, &FileFacts)| {
                spelt.contains(values.1) && beside(other)
            };
            let (_, better) = fitting.into_iter().find(better)?;
            Some(Suspect {
                link: *link,
                better,
                values,
            })
        })
        .collect()
}
