//! What a macro definition leaves unlisted, and the unused files that were made for it.
//!
//! `macro-missing-combination` reports it; `macro-unreferenced-target` is silent about the files
//! named there.

use std::collections::BTreeSet;

use super::absence::{Absence, absences};
use super::combination_patterns::{index, is_walkable};
use super::component::unknown_patterns;
use super::links::is_in_folder;
use super::listing::Listing;
use super::sound::sound_space;
use super::space::{Combination, Space};
use super::spelled::Spelled;
use mhlint_diag::Suggestions;
use mhlint_formats::macro_json::Macrodef;
use mhlint_repo::FileFacts;
use mhlint_repo::makehuman2::Base;

/// Cells times files that are compared at most.
const COMPARED: usize = 1 << 24;

/// The absent combinations of a definition.
pub(super) struct Survey<'s> {
    pub(super) space: Space<'s>,
    /// Number of combinations that are listed.
    pub(super) listed: usize,
    /// Systems and holes; nothing if the product is too large to be walked.
    pub(super) absent: Option<[Absence; 2]>,
    /// Unused files made for the holes.
    pub(super) files: Vec<&'s FileFacts>,
}

/// Nothing if something else that is reported decides which combinations are listed.
pub(super) fn survey<'s>(
    base: &Base<'s>,
    macrodef: &'s Macrodef,
    free: &[&'s FileFacts],
    suggestions: &Suggestions,
) -> Option<Survey<'s>> {
    let (file, macros) = base.macro_file()?;
    // Without sliders nothing tells which values are neutral; the missing file is reported itself.
    base.modelling.winner()?;
    let space = sound_space(file, macros, macrodef)?;
    // A dead definition has no corners, whatever it lists.
    if space
        .axes
        .iter()
        .any(|axis| !unknown_patterns(base, axis).is_empty())
    {
        return None;
    }
    if macrodef
        .links
        .iter()
        .any(|link| space.spellings(&link.name) > 1)
    {
        return None; // Which combinations are listed is open: `macro-ambiguous-value`.
    }
    let mut listing = Listing::of(&space, macrodef, suggestions);
    // One table holds all names: what another definition lists is found for this one too.
    let elsewhere = macros
        .macrodefs
        .iter()
        .filter(|other| other.index != macrodef.index);
    listing.claimed.extend(
        elsewhere
            .flat_map(|other| &other.links)
            .filter_map(|link| space.parse(&link.name)),
    );
    // Entries that the schema rejects, or with names that nobody understands, stand for
    // combinations.
    let faulty = file
        .schema
        .inside(&format!("/macrodef/{}/targets", macrodef.index))
        .count();
    let lost = listing
        .strangers
        .iter()
        .filter(|stranger| stranger.intended.is_none())
        .count();
    let listed = listing.found.len();
    if lost > listed || faulty > listed {
        return None;
    }
    if !is_walkable(&space.sizes()) {
        return Some(Survey {
            space,
            listed,
            absent: None,
            files: Vec::new(),
        });
    }
    let free: Vec<&FileFacts> = free
        .iter()
        .copied()
        .filter(|file| is_in_folder(base, macrodef, file))
        .collect();
    let (wanted, mut files) = wanted(&space, &listing, &free);
    let [system, mut holes] = absences(base, &space, &listing, &wanted);
    if holes.count <= faulty + lost {
        holes = Absence::default();
    }
    if macrodef.links.is_empty() && !files.is_empty() {
        // Nothing is listed, so that all files of the folder wait for one and the same reason.
        files = free;
    }
    Some(Survey {
        space,
        listed,
        absent: Some([system, holes]),
        files,
    })
}

/// The absent cells that unused files were made for, and those files. A file that fits a listed
/// combination is none of them: that entry should name it.
fn wanted<'s>(
    space: &Space<'_>,
    listing: &Listing<'_>,
    free: &[&'s FileFacts],
) -> (Vec<bool>, Vec<&'s FileFacts>) {
    let sizes = space.sizes();
    let total: usize = sizes.iter().product();
    let mut cells = vec![false; total];
    let mut files = Vec::new();
    if total.saturating_mul(free.len()) > COMPARED {
        return (cells, files);
    }
    let used: BTreeSet<(usize, usize)> = listing
        .found
        .keys()
        .flat_map(|c| c.iter().copied().enumerate())
        .collect();
    // Where a file leaves a component open, the values that the definition knows are likelier.
    let strange = |c: &Combination| {
        c.iter()
            .copied()
            .enumerate()
            .filter(|value| !used.contains(value))
            .count()
    };
    for file in free {
        let spelled = Spelled::of(space, file.stem());
        let taken = || listing.found.keys().chain(&listing.claimed);
        if spelled.is_empty() || taken().any(|combination| spelled.fits(combination)) {
            continue;
        }
        let fitting = spelled.combinations(&sizes);
        let least = fitting.iter().map(strange).min();
        for combination in fitting
            .iter()
            .filter(|combination| Some(strange(combination)) == least)
        {
            if let Some(cell) = cells.get_mut(index(&sizes, combination)) {
                *cell = true;
            }
        }
        files.push(*file);
    }
    (cells, files)
}
