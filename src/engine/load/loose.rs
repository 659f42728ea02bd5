//! Loose assets: the files of a tree without a data root, put where the application would look for them.

use std::collections::{BTreeMap, BTreeSet};

use super::input::Input;
use crate::config::Config;
use crate::diag::{Note, Outcome};
use crate::discover::{DataRoot, loose_place};
use crate::source::{EntryKind, Tree};

/// Places below a user's data root by path from the top of the tree.
pub(in crate::engine) type Moved = BTreeMap<String, String>;

/// Where the files of each input would be kept; nothing for inputs that hold data roots.
pub(in crate::engine) fn moved(
    inputs: &[Input],
    roots: &[Vec<DataRoot>],
    system: Option<&Tree>,
    options: &Config,
    outcome: &mut Outcome,
) -> Vec<Moved> {
    let bases = system.map(base_meshes).unwrap_or_default();
    let base = base_for(&bases, options);
    let moved = |(input, roots): (&Input, &Vec<DataRoot>)| {
        if roots.is_empty() { places(&input.tree, base.as_deref()) } else { Moved::new() }
    };
    let all: Vec<Moved> = inputs.iter().zip(roots).map(moved).collect();
    if base.is_none() && all.iter().any(|moved| !moved.is_empty()) {
        outcome.notes.push(Note::Alone { bases: bases.into_iter().collect() });
    }
    all
}

fn places(tree: &Tree, base: Option<&str>) -> Moved {
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    files.filter_map(|entry| Some((entry.path.clone(), loose_place(&entry.path, base)?))).collect()
}

/// The base mesh that loose files are for: the one asked for, or the only one there is.
fn base_for(bases: &BTreeSet<String>, options: &Config) -> Option<String> {
    match options.bases.as_slice() {
        [asked] => bases.get(asked).cloned(),
        _ if bases.len() == 1 => bases.first().cloned(),
        _ => None,
    }
}

fn base_meshes(tree: &Tree) -> BTreeSet<String> {
    let meshes = tree.entries().iter().filter_map(|entry| {
        let (folder, file) = entry.path.rsplit_once('/')?;
        let (above, name) = folder.rsplit_once('/')?;
        let is_base = file == "base.obj" && (above == "base" || above.ends_with("/base"));
        is_base.then(|| name.to_owned())
    });
    meshes.collect()
}
