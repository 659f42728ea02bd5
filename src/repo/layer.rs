//! Layers of a data tree, weakest first, and the lookups over them.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use unicode_normalization::{UnicodeNormalization, is_nfc};

use super::{Base, FileFacts, Reference};
use crate::diag::Application;
use crate::discover::{Kind, Layout, kind_of, owner_of, uses_of};
use crate::source::WalkFault;

/// A path as a system compares it that regards neither capitals nor the form of accented letters.
pub fn fold(path: &str) -> String {
    composed(path).to_lowercase()
}

/// A path with whole letters where it has separate accent marks (Unicode normalization form C).
pub fn composed(path: &str) -> Cow<'_, str> {
    if path.is_ascii() || is_nfc(path) { Cow::Borrowed(path) } else { path.nfc().collect() }
}

/// One data root with the facts of its files.
#[derive(Debug)]
pub struct Layer {
    /// Path of the root as reports print it, empty for the working directory.
    pub path: String,
    /// The layouts that it has.
    pub layouts: Vec<&'static Layout>,
    /// Files by their path relative to the root.
    pub files: BTreeMap<String, FileFacts>,
    /// Folders, relative to the root.
    pub folders: Vec<String>,
    /// What the walk could not list, relative to the root.
    pub walk_faults: Vec<WalkFault>,
    /// Folded paths to paths, made when first asked for; with the number of files it was made for.
    folded: OnceLock<(usize, BTreeMap<String, String>)>,
}

/// The layers that an application sees together; the top one is judged.
#[derive(Debug)]
pub struct Repository<'a> {
    /// Whose data it is.
    pub application: Application,
    /// System data (`data/` beside the program).
    pub system: Option<&'a Layer>,
    /// User data. May be the same root as the system data when one root holds base meshes and `contarget/`.
    pub user: Option<&'a Layer>,
    /// The layer that findings are reported for.
    pub judged: &'a Layer,
    /// The base meshes of all layers, resolved.
    pub bases: Vec<Base<'a>>,
    /// Everything that names a file, and what it leads to.
    pub references: Vec<Reference<'a>>,
}

/// A folder that targets are loaded from.
#[derive(Debug, Clone, Copy)]
pub struct TargetFolder<'a> {
    /// Its layer.
    pub layer: &'a Layer,
    /// `target` or `contarget`.
    pub folder: &'static str,
    /// Base mesh.
    pub base: &'a str,
}

impl Layer {
    /// A layer of these files.
    pub fn new(
        path: String,
        layouts: Vec<&'static Layout>,
        files: BTreeMap<String, FileFacts>,
        folders: Vec<String>,
        walk_faults: Vec<WalkFault>,
    ) -> Self {
        Self { path, layouts, files, folders, walk_faults, folded: OnceLock::new() }
    }

    /// The file at a path relative to the root.
    pub fn file(&self, rel: &str) -> Option<&FileFacts> {
        self.files.get(rel)
    }

    /// What the file at a path is for, or would be if there were one.
    pub fn kind_at(&self, rel: &str) -> Kind {
        self.file(rel).map_or_else(|| kind_of(&uses_of(rel, &self.layouts)), |file| file.kind)
    }

    /// The base mesh that what is at a path belongs to.
    pub fn base_at(&self, rel: &str) -> Option<String> {
        owner_of(&uses_of(rel, &self.layouts)).map(str::to_owned)
    }

    /// All files below a folder (no trailing slash), in order.
    pub fn below<'s>(&'s self, folder: &str) -> impl Iterator<Item = &'s FileFacts> + use<'s> {
        let prefix = format!("{folder}/");
        let from = self.files.range(prefix.clone()..);
        from.take_while(move |(rel, _)| rel.starts_with(&prefix)).map(|(_, file)| file)
    }

    /// The file whose path differs from `rel` in nothing but case, or the form of its accented letters.
    pub fn file_ignoring_case(&self, rel: &str) -> Option<&FileFacts> {
        let wanted = fold(rel);
        let (files, folded) = self.folded.get_or_init(|| (self.files.len(), self.folded()));
        if *files == self.files.len() {
            return self.files.get(folded.get(&wanted)?);
        }
        // Files were added since.
        self.files.values().find(|file| fold(&file.rel) == wanted)
    }

    /// Of paths that differ in case only, the first.
    fn folded(&self) -> BTreeMap<String, String> {
        let mut folded = BTreeMap::new();
        for rel in self.files.keys() {
            folded.entry(fold(rel)).or_insert_with(|| rel.clone());
        }
        folded
    }

    /// Path of something in this layer as reports print it.
    pub fn display(&self, rel: &str) -> String {
        if let Some(file) = self.file(rel) {
            return file.path.clone();
        }
        if let Some(folder) = self.below(rel).next().filter(|file| file.is_loose()).map(FileFacts::folder) {
            return if folder.is_empty() { ".".to_owned() } else { folder.to_owned() };
        }
        if self.path.is_empty() { rel.to_owned() } else { format!("{}/{rel}", self.path) }
    }

    /// Whether something other than a file stands at a path, or above it something that could not be walked.
    pub fn has_unusable(&self, rel: &str) -> bool {
        let is_here = |fault: &WalkFault| {
            let below = rel.strip_prefix(fault.path.as_str());
            below.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
        };
        // Folders with other names, such as those of images, are not reported.
        let is_folder = self.kind_at(rel).is_text() && self.folders.iter().any(|folder| folder == rel);
        is_folder || self.walk_faults.iter().any(is_here)
    }

    /// Whether a path as reports print it lies in this layer.
    pub fn holds(&self, path: &str) -> bool {
        self.relative(path).is_some()
    }

    /// The part of a printed path below this root.
    pub fn relative<'p>(&self, path: &'p str) -> Option<&'p str> {
        if self.path.is_empty() {
            return Some(path);
        }
        path.strip_prefix(self.path.as_str())?.strip_prefix('/')
    }
}

impl<'a> Repository<'a> {
    /// Whether one root plays both parts.
    pub fn is_one_root(&self) -> bool {
        matches!((self.system, self.user), (Some(system), Some(user)) if std::ptr::eq(system, user))
    }

    /// The layers, strongest first.
    pub fn strongest_first(&self) -> impl Iterator<Item = &'a Layer> + use<'a> {
        let system = if self.is_one_root() { None } else { self.system };
        self.user.into_iter().chain(system)
    }

    /// The first existing file, user before system.
    pub fn first_existing(&self, rel: &str) -> Option<&'a FileFacts> {
        self.strongest_first().find_map(|layer| layer.file(rel))
    }

    /// Whether a file belongs to the judged layer.
    pub fn is_judged(&self, file: &FileFacts) -> bool {
        self.judged.file(&file.rel).is_some_and(|own| std::ptr::eq(own, file))
    }
}

impl<'a> TargetFolder<'a> {
    /// Path relative to its root, without trailing slash.
    pub fn rel(&self) -> String {
        format!("{}/{}", self.folder, self.base)
    }

    /// The target `name` (path without suffix).
    pub fn target(&self, name: &str) -> Option<&'a FileFacts> {
        self.layer.file(&format!("{}/{}/{name}.target", self.folder, self.base))
    }

    /// `compressedtargets.npz` of the folder.
    pub fn archive(&self) -> Option<&'a FileFacts> {
        self.layer.file(&format!("{}/{}/compressedtargets.npz", self.folder, self.base))
    }

    /// All targets in the folder.
    pub fn targets(&self) -> impl Iterator<Item = &'a FileFacts> + use<'a> {
        self.layer.below(&self.rel()).filter(|file| file.kind == Kind::Target)
    }

    /// Name of a target of this folder as files refer to it: path without suffix.
    pub fn name_of<'f>(&self, file: &'f FileFacts) -> Option<&'f str> {
        file.rel.strip_prefix(&self.rel())?.strip_prefix('/')?.strip_suffix(".target")
    }

    /// Whether anything is in it.
    pub fn exists(&self) -> bool {
        self.layer.below(&self.rel()).next().is_some()
    }
}
