//! A data root: listing to a layer of facts, in parallel, meshes before what is measured against
//! them.
//!
//! Targets come last and one base at a time, so that only the rows of one base are in memory.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use rayon::prelude::*;
use xxhash_rust::xxh3::xxh3_64;

use super::data::Loaded;
use super::place::Place;
use super::read;
use mhlint_diag::grouped;
use mhlint_discover::{Candidate, Kind, Role, extension};
use mhlint_evaluate::Rows;
use mhlint_formats::Format;
use mhlint_formats::Needs;
use mhlint_formats::obj::Mesh;
use mhlint_formats::target::{MeshSize, Row};
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::{Entry, Limits, Tree, WalkFault, WalkFaultKind, folder_and_name, inside};

/// Sizes of base meshes by name.
pub(crate) type MeshSizes = BTreeMap<String, KnownMesh>;

/// The base mesh that targets and weights are measured against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KnownMesh {
    /// Its size. Against a damaged mesh every index would be wrong; the mesh itself is the fault
    /// then.
    pub(super) size: Option<MeshSize>,
    /// Whether it is an archive, which is read before any OBJ, in whatever layer that is.
    is_packed: bool,
}

/// What reads the files of a data root.
#[derive(Clone, Copy)]
pub(super) struct Reader<'r> {
    pub(super) limits: &'r Limits,
    /// The same data root on the other side of a comparison: what is the same there is not read
    /// again.
    pub(super) other: Option<&'r Loaded<'r>>,
}

/// Reads everything in a data root but the bulk. `sizes` are those of meshes below; its own take
/// their place.
pub(super) fn load(
    place: &Place<'_>,
    reader: Reader<'_>,
    mut sizes: MeshSizes,
) -> (Layer, MeshSizes) {
    let of = |needs: Needs| {
        place
            .files()
            .filter(|file| Format::of(file.kind()).needs == needs)
            .collect()
    };
    let (mut files, _) = read_all(place.tree, of(Needs::Nothing), reader, &sizes, None);
    add_own(&mut sizes, &files);
    files.append(&mut read_all(place.tree, of(Needs::Mesh), reader, &sizes, None).0);
    hash_equal_sizes(place, &mut files, reader.limits);
    let mut layer = Layer::new(
        place.path(),
        place.layouts.clone(),
        files,
        folders(place),
        faults_below(place),
    );
    layer.is_loose = place.is_loose;
    let links = place
        .below
        .iter()
        .filter(|one| !one.is_file() && one.entry.link_to.is_some());
    layer.pack.clone_from(&place.pack);
    layer.linked_folders = links.map(|folder| folder.rel.to_string()).collect();
    layer.linked_folders.sort_unstable();
    (layer, sizes)
}

/// The folders of a place, of files that are put elsewhere those that come about.
fn folders(place: &Place<'_>) -> Vec<String> {
    let listed = || {
        place
            .below
            .iter()
            .filter(|one| !one.is_file())
            .map(|folder| folder.rel.to_string())
    };
    if place.pack.as_ref().is_none_or(|pack| pack.import.is_none()) {
        return listed().collect();
    }
    let made = place.below.iter().flat_map(|file| {
        file.rel
            .match_indices('/')
            .filter_map(|(at, _)| file.rel.get(..at))
    });
    made.collect::<BTreeSet<_>>()
        .into_iter()
        .map(str::to_owned)
        .collect()
}

/// Enters the targets into `layer` without reading them.
pub(crate) fn list_targets(place: &Place<'_>, layer: &mut Layer) {
    layer.add(
        place
            .bulk()
            .map(|file| (file.rel.to_string(), read::unread(place.tree, file)))
            .collect(),
    );
}

/// Files by their path relative to the root.
type ByRel = BTreeMap<String, FileFacts>;

/// Reads files; gives the rows of targets by printed path if they are to be kept, beside those of
/// the other side.
pub(super) fn read_all(
    tree: &Tree,
    files: Vec<&Candidate<'_>>,
    reader: Reader<'_>,
    sizes: &MeshSizes,
    keep_rows: Option<&Rows>,
) -> (ByRel, Rows) {
    if files.is_empty() {
        return (ByRel::new(), Rows::new());
    }
    // What several links lead to is read once; what a fix has made of one of them is known there
    // alone.
    let alike = grouped(files.into_iter().map(|file| {
        let path = file.entry.path.as_str();
        let real = file
            .entry
            .link_to
            .as_deref()
            .filter(|_| !tree.is_changed(path))
            .unwrap_or(path);
        (
            (
                real,
                tree.is_changed(path),
                file.kind(),
                size_for(file, sizes),
            ),
            file,
        )
    }));
    let mut alike: Vec<_> = alike.into_values().collect();
    // The biggest first, so that no thread starts on a large file when the others are done.
    alike.sort_by_key(|files| Reverse(files.first().map(|file| file.entry.size)));
    let is_packed = |entry: &Entry| extension(&entry.path) == "gz";
    let has_packed = alike.iter().flatten().any(|file| is_packed(file.entry));
    let packed = if has_packed {
        tree.entries()
            .iter()
            .filter(|entry| is_packed(entry))
            .count()
    } else {
        0
    };
    let limits = reader.limits.among(packed);
    let read = |file: &Candidate<'_>| {
        let size = size_for(file, sizes);
        if let Some(facts) = reader
            .other
            .and_then(|other| other.shared(tree, file, size, reader.limits))
        {
            let rows = keep_rows
                .and_then(|others| others.get(&facts.path))
                .cloned();
            return (facts, rows);
        }
        let read = || read::read(tree, file, &limits, size);
        let read = catch_unwind(AssertUnwindSafe(read));
        let (facts, mut rows) = read.unwrap_or_else(|_| (read::panicked(tree, file), Vec::new()));
        rows.shrink_to_fit();
        (
            facts,
            keep_rows
                .filter(|_| !rows.is_empty())
                .map(|_| Arc::new(rows)),
        )
    };
    let read_alike = |files: Vec<&Candidate<'_>>| -> Vec<(FileFacts, Option<Arc<Vec<Row>>>)> {
        let mut files = files.into_iter();
        let Some((facts, rows)) = files.next().map(read) else {
            return Vec::new();
        };
        let others = files.map(|file| (read::behind_link(tree, file, &facts), rows.clone()));
        let others: Vec<_> = others.collect();
        std::iter::once((facts, rows)).chain(others).collect()
    };
    let readings: Vec<_> = alike
        .into_par_iter()
        .with_max_len(1)
        .flat_map_iter(read_alike)
        .collect();
    let mut files = ByRel::new();
    let mut kept = Rows::new();
    for (facts, rows) in readings {
        if let Some(rows) = rows {
            kept.insert(facts.path.clone(), rows);
        }
        files.insert(facts.rel.clone(), facts);
    }
    (files, kept)
}

/// Size of the mesh that a file is measured against.
pub(super) fn size_for(file: &Candidate<'_>, sizes: &MeshSizes) -> Option<MeshSize> {
    let is_measured = Format::of(file.kind()).needs != Needs::Nothing;
    sizes.get(file.owner().filter(|_| is_measured)?)?.size
}

/// Puts the meshes of a data root over those below it.
fn add_own(sizes: &mut MeshSizes, files: &ByRel) {
    for file in files.values().filter(|file| file.kind.is_base_mesh()) {
        let Some(base) = file.base() else { continue };
        let is_packed = file.kind == Kind::MeshArchive;
        let size = file.mesh().filter(|mesh| mesh.is_sound()).map(Mesh::size);
        let is_behind_archive = || sizes.get(base).is_some_and(|other| other.is_packed);
        if is_packed || size.is_some() && !is_behind_archive() {
            sizes.insert(base.to_owned(), KnownMesh { size, is_packed });
        }
    }
}

/// Pictures are compared by content only where their sizes are equal; others need no reading.
fn hash_equal_sizes(place: &Place<'_>, files: &mut ByRel, limits: &Limits) {
    let by_size = grouped(place.files().filter_map(|candidate| {
        let file = files
            .get(&*candidate.rel)
            .filter(|file| is_compared(file))?;
        Some((file.size, candidate))
    }));
    let twins: Vec<_> = by_size
        .into_values()
        .filter(|twins| twins.len() > 1)
        .flatten()
        .collect();
    let hash = |file: &Candidate<'_>| {
        place
            .tree
            .read(file.entry, limits)
            .ok()
            .map(|bytes| xxh3_64(&bytes))
    };
    let hashes: Vec<_> = twins
        .into_par_iter()
        .map(|file| (file, hash(file)))
        .collect();
    for (candidate, hash) in hashes {
        if let Some(file) = files.get_mut(&*candidate.rel) {
            file.content_hash = hash;
        }
    }
}

fn is_compared(file: &FileFacts) -> bool {
    matches!(file.kind, Kind::Image | Kind::TargetIcon)
        && file.content_hash.is_none()
        && file.size > 0
}

/// The names of what lies beside a data root and belongs to it.
fn names_beside(place: &Place<'_>) -> BTreeSet<&'static str> {
    let layouts = place.layouts.iter().filter(|one| !one.beside.is_empty());
    let of_users = layouts.filter(|layout| (layout.role)(&place.below) != Role::System);
    of_users
        .flat_map(|layout| layout.beside.iter().copied())
        .collect()
}

/// The path from a data root called `data` to what lies beside it.
fn relative_beside(root: &str, path: &str) -> Option<String> {
    let (above, name) = folder_and_name(root);
    let rel = inside(path, above)?;
    (name == "data").then(|| format!("../{rel}"))
}

fn faults_below(place: &Place<'_>) -> Vec<WalkFault> {
    // What is damaged outside of data roots is none of ours.
    if place.is_loose {
        return Vec::new();
    }
    let (tree, root) = (place.tree, place.root.as_str());
    let (above, name) = folder_and_name(root);
    let names = if name == "data" && !tree.faults().is_empty() {
        names_beside(place)
    } else {
        BTreeSet::new()
    };
    let top = |rel: &str| {
        rel.strip_prefix("../")?
            .split('/')
            .next()
            .map(str::to_owned)
    };
    let is_beside = |rel: &String| top(rel).is_some_and(|top| names.contains(top.as_str()));
    let relative = |path: &str| {
        let beside = || relative_beside(root, path).filter(is_beside);
        inside(path, root).map(str::to_owned).or_else(beside)
    };
    let beside = names.iter().flat_map(|name| {
        let folder = if above.is_empty() {
            (*name).to_owned()
        } else {
            format!("{above}/{name}")
        };
        tree.faults_at(&folder)
            .iter()
            .chain(tree.faults_in(&folder))
    });
    let faults = tree.faults_in(root).iter().chain(beside);
    faults
        .filter_map(|fault| {
            let path = relative(&fault.path)?;
            let mut kind = fault.kind.clone();
            if let WalkFaultKind::LinkLoop { back_to } = &mut kind {
                *back_to = relative(back_to).unwrap_or_else(|| back_to.clone());
            }
            Some(WalkFault { path, kind })
        })
        .collect()
}
