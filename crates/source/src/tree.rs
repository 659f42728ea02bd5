//! A tree of files, from disk or from memory; callers cannot tell which.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use xxhash_rust::xxh3::xxh3_64;

use super::Limits;
use super::listing::{Room, add_file, add_folders, folders_above, memory_entries};
use super::pack::{Pack, PackFacts};
use super::path::{has_hidden_part, inside};
use super::read::{ends_of, read_bounded, too_large};
use super::walk::{self, Walk, Wanted};
use mhlint_diag::{Grouped, grouped};

/// Contents of files by path, where they are not those that lie there; `None`: there is no such
/// file.
pub type Contents<P> = BTreeMap<P, Option<Vec<u8>>>;

/// The beginning and the end of a file.
pub(crate) type Ends = (Vec<u8>, Vec<u8>);

/// A listed tree. Paths are relative to its top, with forward slashes.
#[derive(Debug)]
pub struct Tree {
    label: String,
    backend: Backend,
    /// Levels that are listed.
    depth: usize,
    entries: Vec<Entry>,
    faults: Vec<WalkFault>,
    /// Journals of runs that fix.
    journals: Vec<PathBuf>,
    /// Contents that stand in for those of files, until they are written.
    changed: BTreeMap<String, Vec<u8>>,
    /// Hashes of what was read first, where somebody watches.
    seen: Option<Mutex<BTreeMap<String, u64>>>,
    /// What is to be known of a zip besides its files.
    pack: Option<Arc<PackFacts>>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Backend {
    Disk(PathBuf),
    Memory(BTreeMap<String, Arc<[u8]>>),
    Packed(Arc<Pack>),
}

/// One thing in a tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Path from the top of the tree, forward slashes; lossy where a name is not Unicode.
    pub path: String,
    /// File, folder or something that cannot be read as either.
    pub kind: EntryKind,
    /// Size in bytes, 0 for folders.
    pub size: u64,
    /// The path as the operating system has it.
    pub native: PathBuf,
    /// Path of the same file without links, where it was reached through a link.
    pub link_to: Option<String>,
}

/// What an entry is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EntryKind {
    /// A regular file (or a link to one inside the tree).
    File,
    /// A folder.
    Folder,
    /// A pipe, socket or device: never opened.
    Special,
}

/// Something the walk met that is no entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WalkFault {
    /// Path from the top of the tree.
    pub path: String,
    /// What.
    pub kind: WalkFaultKind,
}

/// The kinds of [`WalkFault`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WalkFaultKind {
    /// A link that leads back to a folder above it.
    LinkLoop {
        /// That folder.
        back_to: String,
    },
    /// A link out of the tree; not followed.
    LinkLeavesRoot,
    /// A link to nothing.
    DeadLink {
        /// What it says, as it says it; nothing if that cannot be read.
        to: String,
    },
    /// Cannot be listed or resolved.
    Unreadable {
        /// What the operating system says.
        reason: String,
    },
}

/// Why bytes could not be had.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReadFault {
    /// Nothing there, a folder, a pipe, no permission, I/O error.
    Unreadable(String),
    /// Larger than [`Limits::file_bytes`].
    TooLarge {
        /// Size in bytes.
        size: u64,
        /// The limit in bytes.
        limit: u64,
    },
}

impl Tree {
    /// Lists the folder `root`, of hidden files only the `wanted` ones. `label` is what reports put
    /// before the paths.
    pub fn on_disk(label: impl Into<String>, root: impl Into<PathBuf>, wanted: Wanted) -> Self {
        Self::on_disk_to_depth(label, root, usize::MAX, wanted)
    }

    /// The same, not deeper than `depth` levels.
    pub fn on_disk_to_depth(
        label: impl Into<String>,
        root: impl Into<PathBuf>,
        depth: usize,
        wanted: Wanted,
    ) -> Self {
        let root = root.into();
        let Walk {
            entries,
            faults,
            journals,
        } = walk::walk(&root, depth, wanted);
        Self {
            depth,
            journals,
            ..Self::new(label.into(), Backend::Disk(root), entries, faults)
        }
    }

    /// A tree of files held in memory: `Vec<u8>`, or `Arc<[u8]>` where several trees share their
    /// bytes. A path that ends in a slash is a folder, which may be empty.
    pub fn in_memory<B: Into<Arc<[u8]>>>(
        label: impl Into<String>,
        files: impl IntoIterator<Item = (String, B)>,
    ) -> Self {
        let files: BTreeMap<_, Arc<[u8]>> = files
            .into_iter()
            .map(|(path, bytes)| (path, bytes.into()))
            .collect();
        let (entries, faults) = memory_entries(
            files
                .iter()
                .map(|(path, bytes)| (path.as_str(), bytes.len() as u64)),
        );
        Self::new(label.into(), Backend::Memory(files), entries, faults)
    }

    /// A zip, as the folder that it was made of; hidden files as in [`Tree::on_disk`]. Its files
    /// are unpacked when they are read, each on its own.
    pub fn packed(label: impl Into<String>, zip: Vec<u8>, limits: &Limits, wanted: Wanted) -> Self {
        let (pack, facts) = Pack::open(zip, &limits.of_pack());
        let folders: Vec<String> = pack.folders().map(|folder| format!("{folder}/")).collect();
        let is_listed = |(path, _): &(&str, u64)| {
            !has_hidden_part(path) || wanted("", path.trim_end_matches('/'), path.ends_with('/'))
        };
        let all = pack
            .files()
            .chain(folders.iter().map(|folder| (folder.as_str(), 0)))
            .filter(is_listed);
        let (entries, faults) = memory_entries(all.collect::<BTreeMap<_, _>>());
        let tree = Self::new(
            label.into(),
            Backend::Packed(Arc::new(pack)),
            entries,
            faults,
        );
        Self {
            pack: Some(Arc::new(facts)),
            ..tree
        }
    }

    fn new(
        label: String,
        backend: Backend,
        entries: Vec<Entry>,
        mut faults: Vec<WalkFault>,
    ) -> Self {
        faults.sort_by(|one, other| one.path.cmp(&other.path));
        let (changed, seen, pack, journals) = (BTreeMap::new(), None, None, Vec::new());
        Self {
            label,
            backend,
            depth: usize::MAX,
            entries,
            faults,
            journals,
            changed,
            seen,
            pack,
        }
    }

    /// What reports put before the paths; empty for the working directory.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// A path from the top of the tree as reports print it.
    pub fn shown(&self, path: &str) -> String {
        match (self.label.is_empty(), path.is_empty()) {
            (true, _) => path.to_owned(),
            (_, true) => self.label.clone(),
            _ => format!("{}/{path}", self.label),
        }
    }

    /// The reverse: the path from the top of the tree, of one that may be in it.
    pub fn below<'p>(&self, shown: &'p str) -> Option<&'p str> {
        inside(shown, &self.label)
    }

    /// Everything listed, sorted by path.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// What the walk could not list, sorted by path.
    pub fn faults(&self) -> &[WalkFault] {
        &self.faults
    }

    /// What of it lies below a folder.
    pub fn faults_in(&self, folder: &str) -> &[WalkFault] {
        if folder.is_empty() {
            return &self.faults;
        }
        let inside = format!("{folder}/");
        let start = self.faults.partition_point(|fault| fault.path < inside);
        let from = self.faults.get(start..).unwrap_or_default();
        let count = from.partition_point(|fault| fault.path.starts_with(&inside));
        from.get(..count).unwrap_or_default()
    }

    /// What of it lies at a path.
    pub fn faults_at(&self, path: &str) -> &[WalkFault] {
        let by_path = |fault: &WalkFault| fault.path.as_str() < path;
        let from = self.faults.get(self.faults.partition_point(by_path)..);
        let from = from.unwrap_or_default();
        let count = from.partition_point(|fault| fault.path == path);
        from.get(..count).unwrap_or_default()
    }

    /// Journals of runs that fix, where they lie on disk.
    pub fn journals(&self) -> impl Iterator<Item = PathBuf> {
        self.root()
            .into_iter()
            .flat_map(|root| self.journals.iter().map(move |journal| root.join(journal)))
    }

    /// What is to be known of a zip besides the files in it, if it is one.
    pub const fn pack(&self) -> Option<&Arc<PackFacts>> {
        self.pack.as_ref()
    }

    /// The listed entry at `path`.
    pub fn entry(&self, path: &str) -> Option<&Entry> {
        self.entries.get(self.place(path).ok()?)
    }

    /// Whether there is a folder at `path`. The top of the tree is one.
    pub fn is_folder(&self, path: &str) -> bool {
        path.is_empty()
            || self
                .entry(path)
                .is_some_and(|entry| entry.kind == EntryKind::Folder)
    }

    /// Everything in a folder and below it.
    pub fn entries_in(&self, folder: &str) -> &[Entry] {
        if folder.is_empty() {
            return &self.entries;
        }
        let inside = format!("{folder}/");
        let start = self.entries.partition_point(|entry| entry.path < inside);
        let from = self.entries.get(start..).unwrap_or_default();
        let count = from.partition_point(|entry| entry.path.starts_with(&inside));
        from.get(..count).unwrap_or_default()
    }

    /// The first file in a folder or below it.
    pub fn first_file_in(&self, folder: &str) -> Option<&str> {
        let mut files = self.entries_in(folder).iter();
        files
            .find(|entry| entry.kind == EntryKind::File)
            .map(|entry| entry.path.as_str())
    }

    /// The bytes of a listed file, as they are.
    ///
    /// # Errors
    /// When there is nothing to read, or more than the limit.
    pub fn read(&self, entry: &Entry, limits: &Limits) -> Result<Vec<u8>, ReadFault> {
        match entry.kind {
            EntryKind::Folder => return Err(ReadFault::Unreadable("it is a folder".to_owned())),
            EntryKind::Special => {
                return Err(ReadFault::Unreadable("it is not a regular file".to_owned()));
            }
            EntryKind::File => {}
        }
        if entry.size > limits.file_bytes {
            return Err(too_large(entry.size, limits));
        }
        if let Some(bytes) = self.changed.get(&entry.path) {
            return Ok(bytes.clone());
        }
        let bytes = match &self.backend {
            Backend::Disk(root) => read_bounded(&root.join(&entry.native), entry.size, limits),
            Backend::Memory(files) => files
                .get(&entry.path)
                .map(|bytes| bytes.to_vec())
                .ok_or_else(gone),
            Backend::Packed(pack) => match pack.read(&entry.path) {
                Some(bytes) => {
                    bytes.map_err(|_| ReadFault::Unreadable("it cannot be unpacked".to_owned()))
                }
                None => Err(gone()),
            },
        }?;
        if let Some(seen) = &self.seen {
            let mut seen = seen.lock().unwrap_or_else(PoisonError::into_inner);
            seen.entry(entry.path.clone())
                .or_insert_with(|| xxh3_64(&bytes));
        }
        Ok(bytes)
    }

    /// As many first and last bytes of a listed file, or all of it where that is not more.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub fn read_ends(
        &self,
        entry: &Entry,
        ends: (usize, usize),
        limits: &Limits,
    ) -> Result<Ends, ReadFault> {
        let (head, tail) = ends;
        let is_long = entry.size > (head + tail) as u64;
        let is_there = entry.kind == EntryKind::File && !self.changed.contains_key(&entry.path);
        if let (Backend::Disk(root), true) = (&self.backend, is_long && is_there) {
            let ends = ends_of(&root.join(&entry.native), head, tail);
            return ends.map_err(|error| ReadFault::Unreadable(error.to_string()));
        }
        let mut all = self.read(entry, limits)?;
        if !is_long {
            return Ok((all, Vec::new()));
        }
        let end = all
            .get(all.len().saturating_sub(tail)..)
            .unwrap_or_default()
            .to_vec();
        all.truncate(head);
        Ok((all, end))
    }

    /// From now on the hash of what is read first of each file is kept.
    pub fn watch(&mut self) {
        self.seen = Some(Mutex::default());
    }

    /// Hash of what was first read at `path` since [`Tree::watch`].
    pub fn seen(&self, path: &str) -> Option<u64> {
        self.seen
            .as_ref()?
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .get(path)
            .copied()
    }

    /// From now on `bytes` are what is read at `path`, or nothing is there; the file itself stays
    /// as it is.
    pub fn change(&mut self, path: &str, bytes: Option<Vec<u8>>) {
        let Ok(at) = self.place(path) else { return };
        match bytes {
            Some(bytes) => {
                if let Some(entry) = self.entries.get_mut(at) {
                    entry.size = bytes.len() as u64;
                }
                self.changed.insert(path.to_owned(), bytes);
            }
            None => drop(self.entries.remove(at)),
        }
    }

    /// The same tree with other contents, as a commit has it: a folder without a file is gone. What
    /// links lead to is changed where they stand, too.
    #[must_use]
    pub fn with(&self, contents: &Contents<String>) -> Self {
        let links = self
            .entries
            .iter()
            .filter_map(|entry| Some((entry.link_to.as_deref()?, entry.path.as_str())));
        let links = grouped(links);
        let mut entries: BTreeMap<String, Entry> = self
            .entries
            .iter()
            .map(|entry| (entry.path.clone(), entry.clone()))
            .collect();
        let mut changed = self.changed.clone();
        // Where a folder takes the place of a file, or the reverse, the old one goes first.
        let (added, removed): (Vec<_>, Vec<_>) =
            contents.iter().partition(|(_, bytes)| bytes.is_some());
        let mut room = Room(walk::MOST_LETTERS);
        let mut given_up = None;
        for (path, bytes) in removed.into_iter().chain(added) {
            for path in [path.clone()].into_iter().chain(linked(&links, path)) {
                if let Some(bytes) = bytes {
                    if let Err(fault) = room.take(&entries, &path) {
                        given_up = Some(fault);
                        continue;
                    }
                    add_folders(&mut entries, &path);
                    add_file(&mut entries, &path, bytes.len() as u64);
                    changed.insert(path, bytes.clone());
                } else {
                    remove(&mut entries, &path);
                    changed.remove(&path);
                }
            }
        }
        let faults = self
            .faults
            .iter()
            .filter(|fault| !contents.contains_key(&fault.path))
            .cloned();
        let mut faults: Vec<WalkFault> = faults.chain(given_up).collect();
        faults.sort_by(|one, other| one.path.cmp(&other.path));
        let entries = entries.into_values().collect();
        let (label, backend, pack) = (self.label.clone(), self.backend.clone(), self.pack.clone());
        Self {
            label,
            backend,
            depth: self.depth,
            entries,
            faults,
            journals: Vec::new(),
            changed,
            seen: None,
            pack,
        }
    }

    /// Whether what is read at `path` is the same in both trees.
    pub fn shares(&self, path: &str, other: &Self, limits: &Limits) -> bool {
        if self.backend == other.backend && self.changed.get(path) == other.changed.get(path) {
            return true;
        }
        let both = [self, other].map(|tree| tree.entry(path));
        let [Some(own), Some(others)] = both else {
            return false;
        };
        own.size == others.size
            && self
                .read(own, limits)
                .is_ok_and(|own| other.read(others, limits) == Ok(own))
    }

    /// Whether a path holds other bytes than were there.
    pub fn is_changed(&self, path: &str) -> bool {
        self.changed.contains_key(path)
    }

    /// Gives it another label.
    pub fn relabel(&mut self, label: &str) {
        label.clone_into(&mut self.label);
    }

    /// How many levels it is listed to.
    pub const fn depth(&self) -> usize {
        self.depth
    }

    fn place(&self, path: &str) -> Result<usize, usize> {
        self.entries
            .binary_search_by(|entry| entry.path.as_str().cmp(path))
    }

    /// The folder on disk that was listed.
    pub fn root(&self) -> Option<&Path> {
        if let Backend::Disk(root) = &self.backend {
            Some(root)
        } else {
            None
        }
    }
}

/// The other paths of a file: links to it, and what lies there behind links to folders.
fn linked(links: &Grouped<&str, &str>, path: &str) -> BTreeSet<String> {
    let above = folders_above(path)
        .chain([path])
        .filter_map(|meant| Some((links.get(meant)?, path.get(meant.len()..)?)));
    above
        .flat_map(|(links, rest)| links.iter().map(move |link| format!("{link}{rest}")))
        .collect()
}

fn gone() -> ReadFault {
    ReadFault::Unreadable("it no longer exists".to_owned())
}

/// Removes a file, or a folder with all that is in it, and the folders above that held nothing
/// else.
fn remove(entries: &mut BTreeMap<String, Entry>, path: &str) {
    let Some(entry) = entries.remove(path) else {
        return;
    };
    if entry.kind == EntryKind::Folder {
        let below = format!("{path}/");
        let inside = entries
            .range(below.clone()..)
            .map_while(|(path, _)| path.starts_with(&below).then(|| path.clone()));
        for path in inside.collect::<Vec<_>>() {
            entries.remove(&path);
        }
    }
    for folder in folders_above(path).rev() {
        let below = format!("{folder}/");
        if entries
            .range(below.clone()..)
            .next()
            .is_some_and(|(path, _)| path.starts_with(&below))
        {
            return;
        }
        entries.remove(folder);
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn disk_and_memory_look_alike() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("b")).unwrap();
        fs::write(folder.path().join("b/c.txt"), "hello").unwrap();
        fs::write(folder.path().join("a.txt"), "").unwrap();
        fs::create_dir(folder.path().join("d")).unwrap();
        let disk = Tree::on_disk("x", folder.path(), |_, _, _| false);
        let files = [
            ("b/c.txt", b"hello".to_vec()),
            ("a.txt", Vec::new()),
            ("d/", Vec::new()),
        ];
        let memory = Tree::in_memory("x", files.map(|(path, bytes)| (path.to_owned(), bytes)));
        let seen = |tree: &Tree| -> Vec<_> {
            let limits = Limits::default();
            let line = |e: &Entry| (e.path.clone(), e.kind, tree.read(e, &limits).ok());
            tree.entries().iter().map(line).collect()
        };
        assert_eq!(seen(&disk), seen(&memory));
    }

    #[test]
    fn of_a_long_file_the_ends_are_read() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), "abcdefgh").unwrap();
        let memory = Tree::in_memory("", [("a".to_owned(), b"abcdefgh".to_vec())]);
        for tree in [Tree::on_disk("", folder.path(), |_, _, _| false), memory] {
            let ends = |head, tail| {
                tree.read_ends(tree.entry("a").unwrap(), (head, tail), &Limits::default())
            };
            assert_eq!(ends(3, 2), Ok((b"abc".to_vec(), b"gh".to_vec())));
            assert_eq!(ends(4, 4), Ok((b"abcdefgh".to_vec(), Vec::new())));
        }
    }

    #[test]
    fn folders_without_end_are_given_up() {
        let deep = |top: &str| format!("{top}/{}x", "a_folder_of_many/".repeat(5000));
        let tree = Tree::in_memory(
            "",
            [("a/b".to_owned(), Vec::new()), (deep("c"), Vec::new())],
        );
        assert_eq!(
            tree.entries()
                .iter()
                .map(|entry| entry.path.as_str())
                .collect::<Vec<_>>(),
            ["a", "a/b"]
        );
        let unlisted: Vec<&str> = tree
            .faults()
            .iter()
            .map(|fault| fault.path.as_str())
            .collect();
        assert_eq!(unlisted, ["c"]);
        let changed = Tree::in_memory("", [("a".to_owned(), Vec::new())])
            .with(&[(deep("d"), Some(Vec::new()))].into());
        assert_eq!((changed.entries().len(), changed.faults().len()), (1, 1));
    }

    #[test]
    fn changes_are_read_and_the_first_content_is_remembered() {
        let mut tree = Tree::in_memory(
            "",
            ["a", "b"].map(|path| (path.to_owned(), b"old".to_vec())),
        );
        tree.watch();
        let read = |tree: &Tree, path| {
            tree.entry(path)
                .map(|entry| tree.read(entry, &Limits::default()).unwrap())
        };
        assert_eq!(
            (read(&tree, "a"), tree.seen("b")),
            (Some(b"old".to_vec()), None)
        );
        tree.change("a", Some(b"newer".to_vec()));
        tree.change("b", None);
        assert_eq!(
            (read(&tree, "a"), read(&tree, "b")),
            (Some(b"newer".to_vec()), None)
        );
        assert_eq!(
            (tree.seen("a"), tree.entry("a").unwrap().size),
            (Some(xxh3_64(b"old")), 5)
        );
    }

    #[test]
    fn a_tree_with_other_contents_is_as_a_commit_has_it() {
        let tree = Tree::in_memory(
            "",
            ["a/b/c", "a/d", "e", "nested/x", "nested/y/z"]
                .map(|path| (path.to_owned(), b"old".to_vec())),
        );
        let other = tree.with(&Contents::from([
            ("a/b/c".to_owned(), None),
            ("e".to_owned(), Some(b"other".to_vec())),
            ("f/g/h".to_owned(), Some(b"new".to_vec())),
            ("gone".to_owned(), None),
            ("nested".to_owned(), None),
        ]));
        let paths: Vec<&str> = other
            .entries()
            .iter()
            .map(|entry| entry.path.as_str())
            .collect();
        assert_eq!(paths, ["a", "a/d", "e", "f", "f/g", "f/g/h"]);
        let limits = Limits::default();
        assert_eq!(
            other.read(other.entry("f/g/h").unwrap(), &limits),
            Ok(b"new".to_vec())
        );
        let shared = ["a/d", "e", "f/g/h"].map(|path| tree.shares(path, &other, &limits));
        assert_eq!(shared, [true, false, false]);
        let elsewhere = Tree::in_memory("x", [("e".to_owned(), b"other".to_vec())]);
        assert!(other.shares("e", &elsewhere, &limits));
    }

    #[test]
    fn a_folder_is_unreadable_and_a_large_file_is_refused() {
        let tree = Tree::in_memory("", [("a/b".to_owned(), vec![0; 9])]);
        let limits = Limits {
            file_bytes: 8,
            ..Limits::default()
        };
        let read = |path| tree.read(tree.entry(path).unwrap(), &limits);
        assert!(matches!(read("a"), Err(ReadFault::Unreadable(_))));
        assert_eq!(read("a/b"), Err(ReadFault::TooLarge { size: 9, limit: 8 }));
    }
}
