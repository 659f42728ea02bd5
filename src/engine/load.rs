//! A data root: listing to a layer of facts, in parallel, meshes before what is measured against them.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use super::read;
use crate::discover::{Kind, kind_of};
use crate::formats::target::MeshSize;
use crate::repo::{FileFacts, Layer};
use crate::source::{Entry, EntryKind, Limits, Tree, WalkFault, WalkFaultKind};

/// Sizes of base meshes by name.
pub(super) type MeshSizes = BTreeMap<String, MeshSize>;

/// Reads the data root at `root` of `tree`. Sizes of meshes that only `system` has are taken from there.
pub(super) fn load(tree: &Tree, root: &str, limits: &Limits, system: Option<&MeshSizes>) -> (Layer, MeshSizes) {
    let prefix = if root.is_empty() { String::new() } else { format!("{root}/") };
    let mut early = Vec::new();
    let mut late = Vec::new();
    let mut folders = Vec::new();
    for entry in tree.entries() {
        let Some(rel) = entry.path.strip_prefix(&prefix) else { continue };
        if entry.kind == EntryKind::Folder {
            folders.push(rel.to_owned());
        } else if needs_mesh(rel) {
            late.push((entry, rel));
        } else {
            early.push((entry, rel));
        }
    }
    let no_size = |_: &str| None;
    let mut files = read_all(tree, early, limits, &no_size);
    let mut sizes = system.cloned().unwrap_or_default();
    sizes.extend(own_sizes(&files));
    files.append(&mut read_all(tree, late, limits, &|rel| kind_of(rel).1.and_then(|base| sizes.get(base).copied())));
    hash_equal_sizes(tree, &prefix, &mut files, limits);
    let layer = Layer { path: join(tree.label(), root), files, folders, walk_faults: faults_below(tree, &prefix) };
    (layer, sizes)
}

fn needs_mesh(rel: &str) -> bool {
    match kind_of(rel).0 {
        Kind::Target => true,
        Kind::Weights => rel.starts_with("rigs/"),
        _ => false,
    }
}

type ByRel = BTreeMap<String, FileFacts>;

fn read_all(
    tree: &Tree,
    mut entries: Vec<(&Entry, &str)>,
    limits: &Limits,
    size_of: &(dyn Fn(&str) -> Option<MeshSize> + Sync),
) -> ByRel {
    // The biggest first, so that no thread starts on a large file when the others are done.
    entries.sort_by_key(|(entry, _)| std::cmp::Reverse(entry.size));
    entries
        .into_par_iter()
        .with_max_len(1)
        .map(|(entry, rel)| {
            let read = || read::read(tree, entry, rel, limits, size_of(rel));
            let facts = catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| read::panicked(tree, entry, rel));
            (rel.to_owned(), facts)
        })
        .collect()
}

fn own_sizes(files: &ByRel) -> MeshSizes {
    let meshes = files.values().filter_map(|file| Some((file.base.clone()?, file.mesh()?)));
    // Against a mesh without vertices every index would be wrong; the mesh itself is the fault then.
    let meshes = meshes.filter(|(_, mesh)| mesh.facts.vertices > 0);
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

pub(super) fn join(label: &str, path: &str) -> String {
    match (label.is_empty(), path.is_empty()) {
        (true, _) => path.to_owned(),
        (_, true) => label.to_owned(),
        _ => format!("{label}/{path}"),
    }
}
