//! A data root: listing to a layer of facts, in parallel, meshes before what is measured against them.
//!
//! Targets come last and one base at a time, so that only the rows of one base are in memory.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use super::loose::Moved;
use super::read;
use crate::discover::{Kind, kind_of};
use crate::evaluate::Rows;
use crate::formats::target::MeshSize;
use crate::repo::{FileFacts, Layer};
use crate::source::{Entry, EntryKind, Limits, Tree, WalkFault, WalkFaultKind};

/// Sizes of base meshes by name.
pub(in crate::engine) type MeshSizes = BTreeMap<String, MeshSize>;

/// A data root in its tree.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Place<'t> {
    pub(in crate::engine) tree: &'t Tree,
    /// Path from the top of the tree.
    pub(in crate::engine) root: &'t str,
    /// Where files that lie loose in the tree would be kept; a real root has none.
    pub(in crate::engine) moved: Option<&'t Moved>,
}

/// Reads everything in a data root but its targets. Sizes of meshes that only `system` has are taken from there.
pub(in crate::engine) fn load(place: Place<'_>, limits: &Limits, system: Option<&MeshSizes>) -> (Layer, MeshSizes) {
    let others = || place.files().filter(|(_, rel)| kind_of(rel).0 != Kind::Target);
    let of = |late: bool| others().filter(move |(_, rel)| waits_for_mesh(rel) == late).collect();
    let (mut files, _) = read_all(place.tree, of(false), limits, &|_| None, false);
    let mut sizes = system.cloned().unwrap_or_default();
    sizes.extend(own_sizes(&files));
    files.append(&mut read_all(place.tree, of(true), limits, &|rel| size_of(rel, &sizes), false).0);
    hash_equal_sizes(place.tree, &place.prefix(), &mut files, limits);
    let folders = place.below().filter(|(entry, _)| entry.kind == EntryKind::Folder);
    let folders = folders.map(|(_, rel)| rel.to_owned()).collect();
    let layer = Layer::new(place.path(), files, folders, faults_below(place.tree, &place.prefix()));
    (layer, sizes)
}

/// Reads the targets of one base (`None`: of no base) into `layer`; gives their rows by printed path if they are to be kept.
pub(in crate::engine) fn load_targets(
    place: Place<'_>,
    layer: &mut Layer,
    base: Option<&str>,
    sizes: &MeshSizes,
    limits: &Limits,
    keep_rows: bool,
) -> Rows {
    let wanted = |(_, rel): &(&Entry, &str)| {
        let (kind, of) = kind_of(rel);
        kind == Kind::Target && of == base
    };
    let entries = place.files().filter(wanted).collect();
    let (mut files, rows) = read_all(place.tree, entries, limits, &|rel| size_of(rel, sizes), keep_rows);
    layer.files.append(&mut files);
    rows
}

/// Enters the targets into `layer` without reading them.
pub(in crate::engine) fn list_targets(place: Place<'_>, layer: &mut Layer) {
    for (entry, rel) in place.files().filter(|(_, rel)| kind_of(rel).0 == Kind::Target) {
        layer.files.insert(rel.to_owned(), read::empty(place.tree, entry, rel));
    }
}

impl<'t> Place<'t> {
    /// Path of the root as reports print it.
    pub(in crate::engine) fn path(self) -> String {
        join(self.tree.label(), self.root)
    }

    /// Path of a file as reports print it.
    pub(super) fn printed(self, file: &Entry) -> String {
        join(self.tree.label(), &file.path)
    }

    fn prefix(self) -> String {
        if self.root.is_empty() { String::new() } else { format!("{}/", self.root) }
    }

    /// Entries below the root with their path relative to it.
    pub(in crate::engine) fn below(self) -> impl Iterator<Item = (&'t Entry, &'t str)> {
        let prefix = self.prefix();
        self.tree.entries().iter().filter_map(move |entry| match self.moved {
            Some(moved) => Some((entry, moved.get(&entry.path)?.as_str())),
            None => Some((entry, entry.path.strip_prefix(&prefix)?)),
        })
    }

    /// Files below the root with their path relative to it.
    pub(super) fn files(self) -> impl Iterator<Item = (&'t Entry, &'t str)> {
        self.below().filter(|(entry, _)| entry.kind != EntryKind::Folder)
    }

    /// Names of the bases that have targets here.
    pub(in crate::engine) fn target_bases(self) -> BTreeSet<Option<&'t str>> {
        let kinds = self.files().map(|(_, rel)| kind_of(rel));
        kinds.filter(|(kind, _)| *kind == Kind::Target).map(|(_, base)| base).collect()
    }
}

/// Size of the mesh that a file is for. Weights beside an asset are for the asset's own mesh.
fn size_of(rel: &str, sizes: &MeshSizes) -> Option<MeshSize> {
    let (kind, base) = kind_of(rel);
    let own_mesh = kind == Kind::Weights && !rel.starts_with("rigs/");
    if own_mesh { None } else { sizes.get(base?).copied() }
}

/// Weights are measured against their mesh, which is read first.
fn waits_for_mesh(rel: &str) -> bool {
    kind_of(rel).0 == Kind::Weights
}

type ByRel = BTreeMap<String, FileFacts>;

fn read_all(
    tree: &Tree,
    mut entries: Vec<(&Entry, &str)>,
    limits: &Limits,
    size_of: &(dyn Fn(&str) -> Option<MeshSize> + Sync),
    keep_rows: bool,
) -> (ByRel, Rows) {
    // The biggest first, so that no thread starts on a large file when the others are done.
    entries.sort_by_key(|(entry, _)| Reverse(entry.size));
    let readings: Vec<read::Reading> = entries
        .into_par_iter()
        .with_max_len(1)
        .map(|(entry, rel)| {
            let read = || read::read(tree, entry, rel, limits, size_of(rel));
            let mut reading = catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| read::panicked(tree, entry, rel));
            if !keep_rows {
                reading.rows = Vec::new();
            }
            reading.rows.shrink_to_fit();
            reading
        })
        .collect();
    let mut files = ByRel::new();
    let mut rows = Rows::new();
    for reading in readings {
        if keep_rows && !reading.rows.is_empty() {
            rows.insert(reading.facts.path.clone(), reading.rows);
        }
        files.insert(reading.facts.rel.clone(), reading.facts);
    }
    (files, rows)
}

fn own_sizes(files: &ByRel) -> MeshSizes {
    let meshes = files.values().filter_map(|file| Some((file.base.clone()?, file.mesh()?)));
    // Against a damaged mesh every index would be wrong; the mesh itself is the fault then.
    let meshes = meshes.filter(|(_, mesh)| mesh.is_sound());
    meshes
        .map(|(base, mesh)| {
            let vertices = mesh.facts.vertices;
            let size = MeshSize { vertices, with_seams: vertices + mesh.facts.seam_duplicates };
            (base, size)
        })
        .collect()
}

/// Pictures are compared by content only where their sizes are equal; others need no reading.
fn hash_equal_sizes(tree: &Tree, prefix: &str, files: &mut ByRel, limits: &Limits) {
    let mut by_size: BTreeMap<u64, Vec<String>> = BTreeMap::new();
    for file in files.values().filter(|file| is_compared(file)) {
        by_size.entry(file.size).or_default().push(file.rel.clone());
    }
    let twins: Vec<String> = by_size.into_values().filter(|rels| rels.len() > 1).flatten().collect();
    let hashes: Vec<(String, Option<u64>)> = twins
        .into_par_iter()
        .map(|rel| {
            let entry = tree.entry(&format!("{prefix}{rel}"));
            let hash = entry.and_then(|entry| read::hash(tree, entry, limits));
            (rel, hash)
        })
        .collect();
    for (rel, hash) in hashes {
        if let Some(file) = files.get_mut(&rel) {
            file.content_hash = hash;
        }
    }
}

fn is_compared(file: &FileFacts) -> bool {
    matches!(file.kind, Kind::Image | Kind::TargetIcon) && file.content_hash.is_none() && file.size > 0
}

fn faults_below(tree: &Tree, prefix: &str) -> Vec<WalkFault> {
    let faults = tree.faults().iter();
    faults
        .filter_map(|fault| {
            let path = fault.path.strip_prefix(prefix)?.to_owned();
            let mut kind = fault.kind.clone();
            if let WalkFaultKind::LinkLoop { back_to } = &mut kind {
                *back_to = back_to.strip_prefix(prefix).unwrap_or(back_to).to_owned();
            }
            Some(WalkFault { path, kind })
        })
        .collect()
}

fn join(label: &str, path: &str) -> String {
    match (label.is_empty(), path.is_empty()) {
        (true, _) => path.to_owned(),
        (_, true) => label.to_owned(),
        _ => format!("{label}/{path}"),
    }
}
