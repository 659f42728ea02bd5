//! PATH arguments to trees: downwards, or upwards when a path lies inside a data root.

#![expect(clippy::disallowed_methods, reason = "what a PATH argument is, a file or a folder, is asked here")]

use std::path::{Path, PathBuf};

use super::super::error::{Error, PathFault};
use super::found::{look_into, roots_of};
use crate::diag::Application;
use crate::discover::{Layout, Listing, Meant, TEST_DATA, find_roots, is_read_though_hidden, new_base};
use crate::source::{
    self, EntryKind, Limits, ReadFault, Tree, folder_name, folder_of, inside, is_below, read_file, slashed,
};

/// A tree to look for data roots in.
pub(in crate::engine) struct Input {
    pub(in crate::engine) tree: Tree,
    /// Report only below these printed paths; empty for everything.
    pub(in crate::engine) narrow: Vec<String>,
    /// The PATHs that led here, as printed.
    pub(in crate::engine) named: Vec<String>,
    /// The base mesh that a zip brings with it, by its name.
    pub(in crate::engine) new_base: Option<String>,
    /// Whether it is the folder around a file that alone was named.
    pub(in crate::engine) is_beside: bool,
    /// The application that alone has a use for it, where it lies among test data.
    pub(in crate::engine) tests: Option<Application>,
}

impl Input {
    pub(in crate::engine) fn whole(tree: Tree) -> Self {
        let named = vec![tree.label().to_owned()];
        let name = tree.label().rsplit('/').next().unwrap_or_default();
        let new_base = tree.pack().and_then(|_| new_base(name)).map(str::to_owned);
        Self { tree, narrow: Vec::new(), named, new_base, is_beside: false, tests: None }
    }

    /// A part of a tree, by its printed path.
    fn part(tree: Tree, path: String) -> Self {
        Self { tree, narrow: vec![path.clone()], named: vec![path], new_base: None, is_beside: false, tests: None }
    }

    /// Whether a printed path is one that the PATHs ask for.
    pub(super) fn asks_for(&self, path: &str) -> bool {
        self.narrow.is_empty() || self.narrow.iter().any(|narrow| is_below(path, narrow))
    }

    /// Takes in another PATH to the same tree.
    fn join(&mut self, mut other: Self) {
        // What lists more is kept.
        if self.is_beside && !other.is_beside {
            std::mem::swap(&mut self.tree, &mut other.tree);
            self.is_beside = false;
        }
        if self.narrow.is_empty() || other.narrow.is_empty() {
            self.narrow.clear();
        } else {
            self.narrow.append(&mut other.narrow);
        }
        self.named.append(&mut other.named);
    }
}

/// Opens the paths, inside data of these applications upwards. A path given twice, or inside another, is opened once.
pub(in crate::engine) fn open(
    paths: &[PathBuf],
    applications: &[Application],
    limits: &Limits,
) -> Result<Vec<Input>, Error> {
    let mut inputs: Vec<(PathBuf, Input)> = Vec::new();
    for path in paths {
        let (place, mut input) = open_one(path, applications, limits)?;
        input.tests = tests_of(path);
        match inputs.iter_mut().find(|(known, _)| *known == place) {
            Some((_, known)) => known.join(input),
            None => inputs.push((place, input)),
        }
    }
    Ok(inputs.into_iter().map(|(_, input)| input).collect())
}

/// Whose test data a path lies among: they stand beside the source of the application.
fn tests_of(path: &Path) -> Option<Application> {
    let place = format!("{}/", slashed(&source::canonical(path)?));
    let (above, _) = place.split_once(&format!("/{}/", TEST_DATA.folder))?;
    Path::new(above).join(TEST_DATA.source).is_dir().then_some(TEST_DATA.application)
}

/// Opens `--system`.
pub(in crate::engine) fn open_system(path: &Path) -> Result<Tree, Error> {
    canonical(path)?;
    Ok(Tree::on_disk(label(path), path, is_read_though_hidden))
}

fn open_one(path: &Path, applications: &[Application], limits: &Limits) -> Result<(PathBuf, Input), Error> {
    let place = canonical(path)?;
    let here = label(path);
    if is_pack(path) {
        return open_pack(path, &here, limits).map(|input| (place, input));
    }
    if place.is_file() {
        let above = open_above(path, &place, &here, applications);
        return Ok(above.unwrap_or_else(|| open_beside(path, &place, &here)));
    }
    let tree = Tree::on_disk(here.clone(), path, is_read_though_hidden);
    let is_no_root = roots_in(&tree, &place).is_empty();
    let above = if is_no_root { open_above(path, &place, &here, applications) } else { None };
    Ok(above.unwrap_or_else(|| (place, Input::whole(tree))))
}

/// Whether a PATH is a zip, by its name: it is checked as the folder that it becomes.
pub(crate) fn is_pack(path: &Path) -> bool {
    let is_zip = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"));
    is_zip && path.is_file()
}

fn open_pack(path: &Path, here: &str, limits: &Limits) -> Result<Input, Error> {
    let zip = read_file(path, limits).map_err(|fault| {
        let reason = match fault {
            ReadFault::Unreadable(reason) => reason,
            ReadFault::TooLarge { limit, .. } => {
                format!("it is larger than {} MiB; unpack it, and check the folder", limit >> 20)
            }
        };
        Error::Path { path: here.to_owned(), fault: PathFault::Unreadable(reason) }
    })?;
    Ok(Input::whole(Tree::packed(here, zip, limits, is_read_though_hidden)))
}
/// Folders of textures and the like below that of a file.
const LEVELS_BESIDE: usize = 4;

/// A file that lies in no data root, with those beside it: they may belong together.
fn open_beside(path: &Path, place: &Path, here: &str) -> (PathBuf, Input) {
    let folder = folder_of(path);
    let tree = Tree::on_disk_to_depth(label(folder), folder, LEVELS_BESIDE, is_read_though_hidden);
    let input = Input { is_beside: true, ..Input::part(tree, here.to_owned()) };
    (place.parent().unwrap_or(place).to_owned(), input)
}

/// The data root that `path` lies inside of.
fn open_above(path: &Path, place: &Path, here: &str, applications: &[Application]) -> Option<(PathBuf, Input)> {
    place.to_str()?;
    let slashed_place = slashed(place);
    let root = applications.iter().find_map(|application| root_above(&slashed_place, Layout::of(*application)))?;
    let levels = place.strip_prefix(&root).ok()?.components().count();
    let written = label_above(path, here, levels);
    // What lies above a link is not above what it leads to.
    let leads_there = source::canonical(Path::new(&written)).is_some_and(|real| real == root);
    let root_label = if leads_there { written } else { label_of_real(&root) };
    let below = slashed(place.strip_prefix(&root).ok()?);
    let narrow = if root_label.is_empty() { below } else { format!("{root_label}/{below}") };
    let tree = Tree::on_disk(root_label, &root, is_read_though_hidden);
    Some((root, Input::part(tree, narrow)))
}

/// The folder above `place` that is a data root of any application, where `layout` has such a one.
fn root_above(place: &str, layout: &Layout) -> Option<PathBuf> {
    within(place, layout).or_else(|| beside(place, layout))
}

/// The folder that holds both a data root called `data` and one beside it that `place` lies in.
fn beside(place: &str, layout: &Layout) -> Option<PathBuf> {
    let parts: Vec<&str> = place.split('/').collect();
    let named = (0..parts.len()).rev().filter(|at| parts.get(*at).is_some_and(|part| layout.beside.contains(part)));
    let mut above = named.map(|at| PathBuf::from(parts.get(..at).unwrap_or_default().join("/")));
    above.find(|above| {
        let data = above.join("data");
        let shallow = || Tree::on_disk_to_depth(String::new(), &data, layout.depth, is_read_though_hidden);
        data.is_dir() && roots_of(&shallow(), &[layout.application], |one| one == layout.application).contains_key("")
    })
}

fn within(place: &str, layout: &Layout) -> Option<PathBuf> {
    let is_root = |root: &PathBuf| {
        let shallow = Tree::on_disk_to_depth(String::new(), root, layout.depth, is_read_though_hidden);
        roots_in(&shallow, root).iter().any(String::is_empty)
    };
    // No application has its data at the top of the disk.
    layout.roots_above(place).filter(|root| !root.is_empty()).map(PathBuf::from).find(is_root)
}

/// The data roots in the tree of a folder, as seen from the one above: its name tells, too, what is in it.
fn roots_in(tree: &Tree, folder: &Path) -> Vec<String> {
    let name = folder_name(folder);
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    let files: Vec<String> = files.map(|entry| format!("{name}/{}", entry.path)).collect();
    let peek = |path: &str| look_into(tree, inside(path, &name)?);
    let listing = Listing::of(files.iter().map(String::as_str), []).with_contents(&peek);
    let roots = find_roots(&listing, Meant::default()).into_iter();
    let below = |root: &str| inside(root, &name).map(str::to_owned).or_else(|| (root == name).then(String::new));
    roots.filter_map(|root| below(&root.path)).collect()
}

/// What is printed for a folder that no written path names: its path below the working directory, else all of it.
fn label_of_real(folder: &Path) -> String {
    let here = source::canonical(Path::new(""));
    slashed(here.and_then(|here| folder.strip_prefix(here).ok()).unwrap_or(folder))
}

/// What is printed for the folder `levels` above `path`.
fn label_above(path: &Path, here: &str, levels: usize) -> String {
    let parts: Vec<&str> = here.split('/').filter(|part| !part.is_empty()).collect();
    let named = parts.iter().filter(|part| **part != "..").count();
    if path.is_absolute() || named >= levels {
        let kept = parts.len().saturating_sub(levels);
        let start = if path.is_absolute() { "/" } else { "" };
        return format!("{start}{}", parts.get(..kept).unwrap_or_default().join("/"));
    }
    let mut up = vec![".."; levels - named];
    up.extend(parts.iter().filter(|part| **part == ".."));
    up.join("/")
}

fn canonical(path: &Path) -> Result<PathBuf, Error> {
    std::fs::canonicalize(path).map_err(|error| Error::Path {
        path: path.display().to_string(),
        fault: PathFault::Unreadable(error.to_string()),
    })
}

/// The path as reports print it: forward slashes, no `./`, empty for the working directory.
fn label(path: &Path) -> String {
    let text = slashed(path);
    let absolute = text.starts_with('/');
    let parts: Vec<&str> = text.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    format!("{}{}", if absolute { "/" } else { "" }, parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_short_and_slashed() {
        assert_eq!(label(Path::new("./data/")), "data");
        assert_eq!(label(Path::new(".")), "");
        assert_eq!(label(Path::new("/a//b/")), "/a/b");
    }

    #[test]
    fn labels_of_folders_above() {
        assert_eq!(label_above(Path::new("x/data/target/b"), "x/data/target/b", 2), "x/data");
        assert_eq!(label_above(Path::new("."), "", 2), "../..");
        assert_eq!(label_above(Path::new("b"), "b", 2), "..");
        assert_eq!(label_above(Path::new("/d/target/b"), "/d/target/b", 2), "/d");
    }
}
