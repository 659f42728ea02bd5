//! PATH arguments to trees: downwards, or upwards when a path lies inside a data root.

#![expect(
    clippy::disallowed_methods,
    reason = "what a PATH argument is, a file or a folder, is asked here"
)]

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::super::error::{Error, PathFault};
use super::found::{look_into, roots_of};
use super::narrow::Narrow;
use mhlint_diag::Application;
use mhlint_discover::{
    Layout, Listing, Meant, TEST_DATA, find_roots, is_read_though_hidden, new_base,
};
use mhlint_source::{
    self as source, EntryKind, Limits, ReadFault, Tree, file_name, folder_name, folder_of, inside,
    read_file, slashed,
};

/// A tree to look for data roots in.
pub(crate) struct Input {
    pub(crate) tree: Tree,
    /// Report only on these printed paths.
    pub(crate) narrow: Arc<Narrow>,
    /// The PATHs that led here, as printed.
    pub(crate) named: BTreeSet<String>,
    /// The base mesh that a zip brings with it, by its name.
    pub(crate) new_base: Option<String>,
    /// Whether it is the folder around a file that alone was named.
    pub(crate) is_beside: bool,
    /// The application that alone has a use for it, where it lies among test data.
    pub(crate) tests: Option<Application>,
}

impl Input {
    pub(crate) fn whole(tree: Tree) -> Self {
        let named = BTreeSet::from([tree.label().to_owned()]);
        let name = file_name(tree.label());
        let new_base = tree.pack().and_then(|_| new_base(name)).map(str::to_owned);
        Self {
            tree,
            narrow: Arc::default(),
            named,
            new_base,
            is_beside: false,
            tests: None,
        }
    }

    /// A part of a tree, by its printed path.
    fn part(tree: Tree, path: String) -> Self {
        Self {
            tree,
            narrow: Arc::new(Narrow::to(vec![path.clone()])),
            named: BTreeSet::from([path]),
            new_base: None,
            is_beside: false,
            tests: None,
        }
    }

    /// Whether a printed path is one that the PATHs ask for.
    pub(super) fn asks_for(&self, path: &str) -> bool {
        self.narrow.asks_for(path)
    }

    /// Whether it is a folder that is opened for parts of it: a data root, or one with data and
    /// what lies beside them.
    fn is_home(&self) -> bool {
        !self.narrow.is_whole() && !self.is_beside && self.tree.pack().is_none()
    }

    /// Takes in another PATH to a part of the same tree.
    fn ask_for(&mut self, path: String) {
        Arc::make_mut(&mut self.narrow).join(&Narrow::to(vec![path.clone()]));
        self.named.insert(path);
    }

    /// Takes in another PATH to the same tree.
    fn join(&mut self, mut other: Self) {
        // What lists more is kept.
        if self.is_beside && !other.is_beside {
            std::mem::swap(self, &mut other);
        }
        self.take_over("", other);
    }

    /// Takes in what is asked for of a folder of this tree, which may be written otherwise there.
    fn take_over(&mut self, folder: &str, other: Self) {
        let here = |path: &String| match other.tree.below(path) {
            Some(rel) if !folder.is_empty() => self.tree.shown(&format!("{folder}/{rel}")),
            Some(rel) => self.tree.shown(rel),
            None => self.tree.shown(folder),
        };
        let named: Vec<String> = other.named.iter().map(here).collect();
        let narrow: Vec<String> = match other.narrow.paths() {
            [] if folder.is_empty() => Vec::new(),
            [] => vec![self.tree.shown(folder)],
            narrow => narrow.iter().map(here).collect(),
        };
        Arc::make_mut(&mut self.narrow).join(&Narrow::to(narrow));
        self.named.extend(named);
    }
}

/// Opens the paths, inside data of an application upwards. A path given twice, or inside
/// another, is opened once.
pub(crate) fn open(paths: &[PathBuf], limits: &Limits) -> Result<Vec<Input>, Error> {
    let mut inputs: Vec<(PathBuf, Input)> = Vec::new();
    let mut places: BTreeMap<PathBuf, usize> = BTreeMap::new();
    let known = KnownRoots::default();
    for path in paths {
        let place = canonical(path)?;
        let part = (place.is_file() && !is_pack(path)).then(|| Part::of_file(path, &place, &known));
        let known_tree = part.as_ref().and_then(|part| {
            let (_, input) = inputs.get_mut(*places.get(&part.root)?)?;
            (input.is_beside == part.is_beside).then_some(input)
        });
        // A hook names many files of one tree: it is walked once.
        if let (Some(input), Some(part)) = (known_tree, &part) {
            let below = place
                .strip_prefix(&part.root)
                .map(slashed)
                .unwrap_or_default();
            input.ask_for(input.tree.shown(&below));
            continue;
        }
        let (root, mut input) = match part {
            Some(part) => part.open(),
            None => open_whole(path, place, limits, &known)?,
        };
        input.tests = tests_of(path);
        if let Some((_, known)) = places.get(&root).and_then(|at| inputs.get_mut(*at)) {
            known.join(input);
        } else {
            places.insert(root.clone(), inputs.len());
            inputs.push((root, input));
        }
    }
    let mut inputs: Vec<_> = inputs
        .into_iter()
        .map(|(root, input)| (root, Some(input)))
        .collect();
    for at in 0..inputs.len() {
        take_in(&mut inputs, &places, at);
    }
    Ok(inputs.into_iter().filter_map(|(_, input)| input).collect())
}

/// Adds what was asked for inside of a folder, which is opened for what lies beside data, to what
/// is asked for of it: the data are the same. `places` are those of the inputs by their tops.
fn take_in(inputs: &mut [(PathBuf, Option<Input>)], places: &BTreeMap<PathBuf, usize>, at: usize) {
    let Some((home, input)) = inputs.get_mut(at) else {
        return;
    };
    let home = home.clone();
    let Some(mut own) = input.take_if(|input| input.is_home()) else {
        return;
    };
    // Paths are in order of their parts, so that those below a folder follow it.
    let inside = places
        .range(home.clone()..)
        .take_while(|(root, _)| root.starts_with(&home));
    for (root, other) in inside.filter(|(_, other)| **other != at) {
        let Ok(folder) = root.strip_prefix(&home).map(slashed) else {
            continue;
        };
        let is_listed =
            own.tree.entry(&folder).is_some() || !own.tree.entries_in(&folder).is_empty();
        let other = inputs.get_mut(*other).map(|(_, other)| other);
        let other = other
            .filter(|_| is_listed)
            .and_then(|other| other.take_if(|other| other.tree.pack().is_none()));
        if let Some(other) = other {
            own.take_over(&folder, other);
        }
    }
    if let Some((_, input)) = inputs.get_mut(at) {
        *input = Some(own);
    }
}

/// Whose test data a path lies among: they stand beside the source of the application.
fn tests_of(path: &Path) -> Option<Application> {
    let place = format!("{}/", slashed(&source::canonical(path)?));
    let (above, _) = place.split_once(&format!("/{}/", TEST_DATA.folder))?;
    Path::new(above)
        .join(TEST_DATA.source)
        .is_dir()
        .then_some(TEST_DATA.application)
}

/// Opens `--system`.
pub(crate) fn open_system(path: &Path) -> Result<Tree, Error> {
    canonical(path)?;
    Ok(Tree::on_disk(label(path), path, is_read_though_hidden))
}

/// Opens a zip, or a folder with all that is in it; inside a data root that, and the folder as a
/// part of it.
fn open_whole(
    path: &Path,
    place: PathBuf,
    limits: &Limits,
    known: &KnownRoots,
) -> Result<(PathBuf, Input), Error> {
    let here = label(path);
    if is_pack(path) {
        return open_pack(path, &here, limits).map(|input| (place, input));
    }
    let tree = Tree::on_disk(here.clone(), path, is_read_though_hidden);
    let is_no_root = roots_in(&tree, &place).is_empty();
    let above = if is_no_root {
        Part::above(path, &place, &here, known)
    } else {
        None
    };
    Ok(above.map_or_else(|| (place, Input::whole(tree)), Part::open))
}

/// Whether a PATH is a zip, by its name: it is checked as the folder that it becomes.
pub fn is_pack(path: &Path) -> bool {
    let is_zip = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("zip"));
    is_zip && path.is_file()
}

fn open_pack(path: &Path, here: &str, limits: &Limits) -> Result<Input, Error> {
    let zip = read_file(path, limits).map_err(|fault| {
        let reason = match fault {
            ReadFault::Unreadable(reason) => reason,
            ReadFault::TooLarge { limit, .. } => {
                format!(
                    "it is larger than {} MiB; unpack it, and check the folder",
                    limit >> 20
                )
            }
        };
        Error::Path {
            path: here.to_owned(),
            fault: PathFault::Unreadable(reason),
        }
    })?;
    Ok(Input::whole(Tree::packed(
        here,
        zip,
        limits,
        is_read_though_hidden,
    )))
}
/// Folders of textures and the like below that of a file.
const LEVELS_BESIDE: usize = 4;

/// What a PATH asks for in a tree that is not walked yet.
struct Part {
    /// The top of the tree.
    root: PathBuf,
    /// Where it is opened, and what is printed for it.
    folder: PathBuf,
    label: String,
    /// What is asked for, as printed.
    narrow: String,
    /// Whether the tree is the folder around a file that lies in no data root: those beside it may
    /// belong to it.
    is_beside: bool,
}

impl Part {
    fn of_file(path: &Path, place: &Path, known: &KnownRoots) -> Self {
        let here = label(path);
        Self::above(path, place, &here, known).unwrap_or_else(|| {
            let folder = folder_of(path).to_owned();
            let root = place.parent().unwrap_or(place).to_owned();
            Self {
                root,
                label: label(&folder),
                folder,
                narrow: here,
                is_beside: true,
            }
        })
    }

    /// The data root that `path` lies inside of.
    fn above(path: &Path, place: &Path, here: &str, known: &KnownRoots) -> Option<Self> {
        place.to_str()?;
        let slashed_place = slashed(place);
        let root_above = |one: &Application| known.above(&slashed_place, Layout::of(*one));
        let root = Application::ALL.iter().find_map(root_above)?;
        let levels = place.strip_prefix(&root).ok()?.components().count();
        let written = label_above(path, here, levels);
        // What lies above a link is not above what it leads to.
        let leads_there = source::canonical(Path::new(&written)).is_some_and(|real| real == root);
        let label = if leads_there {
            written
        } else {
            label_of_real(&root)
        };
        let below = slashed(place.strip_prefix(&root).ok()?);
        let narrow = if label.is_empty() {
            below
        } else {
            format!("{label}/{below}")
        };
        Some(Self {
            folder: root.clone(),
            root,
            label,
            narrow,
            is_beside: false,
        })
    }

    fn open(self) -> (PathBuf, Input) {
        let levels = if self.is_beside {
            LEVELS_BESIDE
        } else {
            usize::MAX
        };
        let tree = Tree::on_disk_to_depth(self.label, &self.folder, levels, is_read_though_hidden);
        (
            self.root,
            Input {
                is_beside: self.is_beside,
                ..Input::part(tree, self.narrow)
            },
        )
    }
}

/// The folders that were looked at for data roots above PATHs: many PATHs lie in the same ones.
#[derive(Default)]
struct KnownRoots {
    are_roots: RefCell<BTreeMap<(PathBuf, Application), bool>>,
    have_data: RefCell<BTreeMap<(PathBuf, Application), bool>>,
}

impl KnownRoots {
    /// The folder above `place` that is a data root of any application, where `layout` has such a
    /// one.
    fn above(&self, place: &str, layout: &Layout) -> Option<PathBuf> {
        self.within(place, layout)
            .or_else(|| self.beside(place, layout))
    }

    /// The folder that holds both a data root called `data` and one beside it that `place` lies in.
    fn beside(&self, place: &str, layout: &Layout) -> Option<PathBuf> {
        let parts: Vec<&str> = place.split('/').collect();
        let named = (0..parts.len()).rev().filter(|at| {
            parts
                .get(*at)
                .is_some_and(|part| layout.beside.contains(part))
        });
        let mut above =
            named.map(|at| PathBuf::from(parts.get(..at).unwrap_or_default().join("/")));
        let has_data = |above: &PathBuf| {
            let data = above.join("data");
            let shallow = || {
                Tree::on_disk_to_depth(String::new(), &data, layout.depth, is_read_though_hidden)
            };
            let is_own = |one: Application| one == layout.application;
            data.is_dir() && roots_of(&shallow(), &[layout.application], is_own).contains_key("")
        };
        above.find(|above| once(&self.have_data, above, layout, || has_data(above)))
    }

    fn within(&self, place: &str, layout: &Layout) -> Option<PathBuf> {
        let is_root = |root: &PathBuf| {
            let shallow =
                Tree::on_disk_to_depth(String::new(), root, layout.depth, is_read_though_hidden);
            roots_in(&shallow, root).iter().any(String::is_empty)
        };
        // No application has its data at the top of the disk.
        let mut roots = layout
            .roots_above(place)
            .filter(|root| !root.is_empty())
            .map(PathBuf::from);
        roots.find(|root| once(&self.are_roots, root, layout, || is_root(root)))
    }
}

/// What was found out of a folder for an application, or is now.
fn once(
    known: &RefCell<BTreeMap<(PathBuf, Application), bool>>,
    folder: &Path,
    layout: &Layout,
    look: impl FnOnce() -> bool,
) -> bool {
    let key = (folder.to_owned(), layout.application);
    if let Some(known) = known.borrow().get(&key) {
        return *known;
    }
    let found = look();
    known.borrow_mut().insert(key, found);
    found
}

/// The data roots in the tree of a folder, as seen from the one above: its name tells, too, what is
/// in it.
fn roots_in(tree: &Tree, folder: &Path) -> Vec<String> {
    let name = folder_name(folder);
    let files = tree
        .entries()
        .iter()
        .filter(|entry| entry.kind == EntryKind::File);
    let files: Vec<String> = files
        .map(|entry| format!("{name}/{}", entry.path))
        .collect();
    let peek = |path: &str| look_into(tree, inside(path, &name)?);
    let listing = Listing::of(files.iter().map(String::as_str), []).with_contents(&peek);
    let roots = find_roots(&listing, Meant::default()).into_iter();
    let below = |root: &str| {
        inside(root, &name)
            .map(str::to_owned)
            .or_else(|| (root == name).then(String::new))
    };
    roots.filter_map(|root| below(&root.path)).collect()
}

/// What is printed for a folder that no written path names: its path below the working directory,
/// else all of it.
fn label_of_real(folder: &Path) -> String {
    let here = source::canonical(Path::new(""));
    slashed(
        here.and_then(|here| folder.strip_prefix(here).ok())
            .unwrap_or(folder),
    )
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
    let parts: Vec<&str> = text
        .split('/')
        .filter(|part| !part.is_empty() && *part != ".")
        .collect();
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
        assert_eq!(
            label_above(Path::new("x/data/target/b"), "x/data/target/b", 2),
            "x/data"
        );
        assert_eq!(label_above(Path::new("."), "", 2), "../..");
        assert_eq!(label_above(Path::new("b"), "b", 2), "..");
        assert_eq!(
            label_above(Path::new("/d/target/b"), "/d/target/b", 2),
            "/d"
        );
    }
}
