//! One data root with the facts of its files.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use unicode_normalization::{UnicodeNormalization, is_nfc};

use super::{FileFacts, Pack};
use mhlint_diag::{Application, Identity};
use mhlint_discover::{Kind, Layout, kind_in, uses_of};
use mhlint_formats::Format;
use mhlint_source::{WalkFault, folders_above, has_hidden_part, inside, is_below, parent};

/// A path as a system compares it that regards neither capitals nor the form of accented letters.
pub fn fold(path: &str) -> String {
    composed(path).to_lowercase()
}

/// A path with whole letters where it has separate accent marks (Unicode normalization form C).
pub fn composed(path: &str) -> Cow<'_, str> {
    if path.is_ascii() || is_nfc(path) {
        Cow::Borrowed(path)
    } else {
        path.nfc().collect()
    }
}

/// One data root with the facts of its files.
#[derive(Debug)]
pub struct Layer {
    /// Path of the root as reports print it, empty for the working directory.
    pub path: String,
    /// Whether it is no data root at all, but files that would belong into one.
    pub is_loose: bool,
    /// The layouts that it has.
    pub layouts: Vec<&'static Layout>,
    /// Files by their path relative to the root.
    pub files: BTreeMap<String, FileFacts>,
    /// Folders, relative to the root.
    pub folders: Vec<String>,
    /// Those of them that are links, relative to the root, in order.
    pub linked_folders: Vec<String>,
    /// Further folders, which are hidden or in a hidden one, and whose names count all the same.
    pub hidden_folders: Vec<String>,
    /// What the walk could not list, relative to the root.
    pub walk_faults: Vec<WalkFault>,
    /// The zip that it was made of, if it was one.
    pub pack: Option<Pack>,
    /// What each application takes it for.
    pub identities: BTreeMap<Application, Identity>,
    /// Folded paths to paths, in order; made when first asked for.
    folded: OnceLock<BTreeMap<String, Vec<String>>>,
    /// Paths in the order of what is below their folder at the top; made when first asked for.
    below_tops: OnceLock<Vec<String>>,
    /// Its folders under their folded forms.
    folded_folders: OnceLock<BTreeSet<String>>,
    /// Printed paths of loose files to their supposed ones; made when first asked for.
    loose: OnceLock<BTreeMap<String, String>>,
    /// Printed paths of what could not be walked and lies beside the root, to those below it.
    faults_beside: OnceLock<BTreeMap<String, String>>,
}

/// The folder at the top of a path, and the rest with its slash.
fn split_top(rel: &str) -> (&str, &str) {
    rel.split_at(rel.find('/').unwrap_or(rel.len()))
}

/// Notes a path under its folded form.
fn enter(folded: &mut BTreeMap<String, Vec<String>>, rel: &str) {
    let alike = folded.entry(fold(rel)).or_default();
    let place = alike.partition_point(|other| other.as_str() < rel);
    alike.insert(place, rel.to_owned());
}

impl Layer {
    /// A layer of these files.
    pub fn new(
        path: String,
        layouts: Vec<&'static Layout>,
        files: BTreeMap<String, FileFacts>,
        folders: Vec<String>,
        mut walk_faults: Vec<WalkFault>,
    ) -> Self {
        let (mut hidden_folders, mut folders): (Vec<_>, Vec<_>) =
            folders.into_iter().partition(|rel| has_hidden_part(rel));
        folders.sort_unstable();
        hidden_folders.sort_unstable();
        walk_faults.sort_by(|one, other| one.path.cmp(&other.path));
        let (linked_folders, folded, loose) = (Vec::new(), OnceLock::new(), OnceLock::new());
        let (is_loose, pack) = (false, None);
        Self {
            path,
            is_loose,
            layouts,
            files,
            folders,
            linked_folders,
            hidden_folders,
            walk_faults,
            pack,
            identities: BTreeMap::new(),
            folded,
            folded_folders: OnceLock::new(),
            below_tops: OnceLock::new(),
            faults_beside: OnceLock::new(),
            loose,
        }
    }

    /// Adds files that were read later.
    pub fn add(&mut self, files: BTreeMap<String, FileFacts>) {
        if let Some(folded) = self.folded.get_mut() {
            files.keys().for_each(|rel| enter(folded, rel));
        }
        self.loose.take();
        self.below_tops.take();
        // `append` would go through all that is there.
        self.files.extend(files);
    }

    /// The file at a path relative to the root.
    pub fn file(&self, rel: &str) -> Option<&FileFacts> {
        self.files.get(rel)
    }

    /// Whether there is a folder at a path.
    pub fn has_folder(&self, rel: &str) -> bool {
        self.folders
            .binary_search_by(|folder| folder.as_str().cmp(rel))
            .is_ok()
    }

    /// The text of an asset, or of a mesh, that an archive at a path is made from: it lies beside
    /// it.
    pub fn text_of_archive(&self, rel: &str) -> Option<&FileFacts> {
        let (stem, extension) = rel.rsplit_once('.')?;
        let texts: &[&str] = match extension {
            "mhbin" | "mhpxy" => &["mhclo", "proxy"],
            "npz" => &["obj"],
            _ => &[],
        };
        texts
            .iter()
            .find_map(|suffix| self.file(&format!("{stem}.{suffix}")))
    }

    /// What the file at a path is for to an application, or would be if there were one.
    pub fn kind_at(&self, rel: &str, application: Application) -> Kind {
        self.file(rel).map_or_else(
            || kind_in(&uses_of(rel, &self.layouts), application),
            |file| file.kind_in(application),
        )
    }

    /// The file at a printed path.
    pub fn printed(&self, path: &str) -> Option<&FileFacts> {
        match self.loose().get(path) {
            Some(rel) => self.file(rel),
            None => self.relative(path).and_then(|rel| self.file(rel)),
        }
    }

    /// The base meshes that what is at a printed path belongs to.
    pub fn bases_at(&self, path: &str) -> Vec<String> {
        let from = self
            .loose()
            .range(path.to_owned()..)
            .take_while(|(own, _)| own.starts_with(path));
        let loose = from
            .filter(|(own, _)| is_below(own, path))
            .map(|(_, rel)| rel.as_str());
        let own = if self.loose().is_empty() {
            self.relative(path)
        } else {
            None
        };
        let at = loose.chain(own);
        let mut bases: Vec<String> = at
            .flat_map(|rel| uses_of(rel, &self.layouts))
            .filter_map(|one| one.owner)
            .collect();
        bases.dedup();
        bases
    }

    fn loose(&self) -> &BTreeMap<String, String> {
        self.loose.get_or_init(|| {
            let loose = self.files.values().filter(|file| file.is_loose);
            loose
                .map(|file| (file.path.clone(), file.rel.clone()))
                .collect()
        })
    }

    /// Whether a path leads through a folder that is a link.
    pub fn is_behind_link(&self, rel: &str) -> bool {
        let is_link = |folder: &str| {
            self.linked_folders
                .binary_search_by(|link| link.as_str().cmp(folder))
                .is_ok()
        };
        !self.linked_folders.is_empty() && folders_above(rel).any(is_link)
    }

    /// All files below a folder (no trailing slash), in order.
    pub fn below<'s>(&'s self, folder: &str) -> impl Iterator<Item = &'s FileFacts> + use<'s> {
        self.beginning_with(format!("{folder}/"))
    }

    /// All files whose path begins so, in order.
    pub fn beginning_with(&self, prefix: String) -> impl Iterator<Item = &FileFacts> + use<'_> {
        let from = self.files.range(prefix.clone()..);
        from.take_while(move |(rel, _)| rel.starts_with(&prefix))
            .map(|(_, file)| file)
    }

    /// The folders at the top that have a file at `below`, which begins with a slash, in order.
    pub fn tops_with<'s>(&'s self, below: &str) -> impl Iterator<Item = &'s str> + use<'s> {
        let rels = self.below_tops.get_or_init(|| {
            let mut rels: Vec<String> = self.files.keys().cloned().collect();
            rels.retain(|rel| rel.contains('/'));
            rels.sort_by(|one, other| split_top(one).1.cmp(split_top(other).1));
            rels
        });
        let from = rels.partition_point(|rel| split_top(rel).1 < below);
        let to = rels.partition_point(|rel| split_top(rel).1 <= below);
        let found = rels.get(from..to).unwrap_or_default();
        found.iter().map(|rel| split_top(rel).0)
    }

    /// The first file whose path differs from `rel` in nothing but case, or the form of its
    /// accented letters.
    pub fn file_ignoring_case(&self, rel: &str) -> Option<&FileFacts> {
        self.alike(rel).first().and_then(|alike| self.file(alike))
    }

    /// The paths of all such files, `rel` among them if it is one.
    pub fn alike(&self, rel: &str) -> &[String] {
        let folded = self.folded.get_or_init(|| {
            let mut folded = BTreeMap::new();
            self.files.keys().for_each(|rel| enter(&mut folded, rel));
            folded
        });
        folded
            .get(&fold(rel))
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// Whether it has a folder whose path differs from `rel` in nothing but case, or the form of
    /// its accented letters.
    pub fn has_folder_ignoring_case(&self, rel: &str) -> bool {
        let folded = self
            .folded_folders
            .get_or_init(|| self.folders.iter().map(|folder| fold(folder)).collect());
        folded.contains(&fold(rel))
    }

    /// Path of something in this layer as reports print it.
    pub fn display(&self, rel: &str) -> String {
        if let Some(file) = self.file(rel) {
            return file.path.clone();
        }
        if let Some(folder) = self
            .below(rel)
            .next()
            .filter(|file| file.is_loose)
            .map(FileFacts::folder)
        {
            return if folder.is_empty() {
                ".".to_owned()
            } else {
                folder.to_owned()
            };
        }
        if let Some(beside) = rel.strip_prefix("../") {
            let above = parent(&self.path);
            return if above.is_empty() {
                beside.to_owned()
            } else {
                format!("{above}/{beside}")
            };
        }
        match (self.path.is_empty(), rel.is_empty()) {
            (true, _) => rel.to_owned(),
            (_, true) => self.path.clone(),
            _ => format!("{}/{rel}", self.path),
        }
    }

    /// The path of a folder to show where one below the data root is wanted.
    pub fn shown<'p>(&'p self, folder: &'p str) -> Cow<'p, str> {
        if self.is_loose {
            self.display(folder).into()
        } else {
            folder.into()
        }
    }

    /// Whether there is something at a path: what cannot be used has a finding of its own.
    pub fn is_there(&self, rel: &str) -> bool {
        self.file(rel).is_some() || self.has_unusable(rel)
    }

    /// Whether something other than a file stands at a path, or above it something that could not
    /// be walked.
    pub fn has_unusable(&self, rel: &str) -> bool {
        // Folders with other names, such as those of images, are not reported.
        self.has_fault(rel)
            || uses_of(rel, &self.layouts)
                .iter()
                .any(|one| Format::of(one.kind).is_text())
                && self.has_folder(rel)
    }

    /// Whether a path, or something above it, could not be walked. That has a finding of its own.
    pub fn has_fault(&self, rel: &str) -> bool {
        let is_fault = |path: &str| {
            self.walk_faults
                .binary_search_by(|fault| fault.path.as_str().cmp(path))
                .is_ok()
        };
        let mut above = rel.match_indices('/').filter_map(|(end, _)| rel.get(..end));
        is_fault(rel) || above.any(is_fault)
    }

    /// Whether a path as reports print it lies in this layer.
    pub fn holds(&self, path: &str) -> bool {
        self.relative(path).is_some()
    }

    /// The part of a printed path below this root.
    pub fn relative<'p>(&'p self, path: &'p str) -> Option<&'p str> {
        let supposed = || self.loose().get(path).map(String::as_str);
        if self.is_loose && path == self.path {
            return Some("");
        }
        inside(path, &self.path)
            .or_else(supposed)
            .or_else(|| self.fault_beside(path))
    }

    /// What could not be walked and lies beside the root.
    fn fault_beside(&self, path: &str) -> Option<&str> {
        let known = self.faults_beside.get_or_init(|| {
            let paths = self.walk_faults.iter().map(|fault| fault.path.as_str());
            let beside = paths.filter(|rel| rel.starts_with("../"));
            beside
                .map(|rel| (self.display(rel), rel.to_owned()))
                .rev()
                .collect()
        });
        known.get(path).map(String::as_str)
    }
}
