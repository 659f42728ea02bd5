//! Files outside of data roots: which of them are ours, and which base mesh they are for.

use std::collections::{BTreeMap, BTreeSet};

use super::super::error::Error;
use super::input::Input;
use super::place::Place;
use crate::config::Config;
use crate::discover::{Binding, Layout, extension};
use crate::formats::target::recognise;
use crate::source::{Entry, is_below};

/// The files of an input outside of its data roots, put where the application would look for them; `None` where there
/// are none. `bases` are those of the system data.
pub(super) fn loose<'t>(
    input: &'t Input,
    roots: &BTreeMap<String, Vec<&'static Layout>>,
    layout: &'static Layout,
    bases: &BTreeSet<String>,
    options: &Config,
) -> Result<Option<Place<'t>>, Error> {
    let asked = match options.bases.as_slice() {
        [asked] if bases.is_empty() || bases.contains(asked) => Some(asked),
        _ => None,
    };
    let only = bases.first().filter(|_| bases.len() == 1);
    let bind = |entry: &Entry| -> Binding {
        let is_in_root = roots.keys().any(|root| is_below(&entry.path, root));
        let header = if is_in_root { None } else { recognised(input, entry, options) };
        header.map(|header| asked.cloned().or(header).or_else(|| only.cloned()))
    };
    let place = Place::loose(&input.tree, layout, bind);
    match place.below.first() {
        Some(first) if options.bases.len() > 1 => {
            Err(Error::SeveralBases { file: input.tree.shown(&first.entry.path) })
        }
        first => Ok(first.is_some().then_some(place)),
    }
}

/// The base mesh in the header of a file that is ours: it is named as PATH, or its content says so. Only targets share
/// their name with files of other programs.
fn recognised(input: &Input, entry: &Entry, options: &Config) -> Binding {
    if extension(&entry.path) != "target" {
        return Some(None);
    }
    let bytes = input.tree.read(entry, &options.limits).unwrap_or_default();
    let target = recognise(&bytes);
    let is_ours = target.is_some() || input.named.contains(&input.tree.shown(&entry.path));
    let header = target.and_then(|target| target.basemesh);
    // A name that is no folder leads elsewhere.
    is_ours.then(|| header.filter(|name| !name.contains(['/', '\\']) && !name.starts_with('.')))
}
