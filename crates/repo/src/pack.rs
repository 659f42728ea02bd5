//! A zip that is checked as the folder it becomes: what is wrong with the zip, and what its import
//! does to paths.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::FileFacts;
use mhlint_discover::Refusal;
use mhlint_source::{PackFacts, normalized, parent};

/// A zip that a layer was made of.
#[derive(Debug, Clone, Default)]
pub struct Pack {
    /// What is wrong with the zip; nothing where another layer of it has that.
    pub faults: Option<Arc<PackFacts>>,
    /// What becomes of its files, where they are not just unpacked.
    pub import: Option<Import>,
    /// Paths below the data root of members that are no files.
    pub lost: BTreeSet<String>,
    /// Why its importer refuses it.
    pub refusal: Option<Refusal>,
    /// Names that whoever packed it meant otherwise than its importer takes them; nothing where
    /// people unpack it.
    pub names: Names,
}

/// Names in a pack that are not those of the files that come of them, as paths below the data root.
#[derive(Debug, Clone, Default)]
pub struct Names {
    /// Names that are read with other letters than they were written with, by path.
    pub misread: BTreeMap<String, String>,
    /// Paths whose names have `\\` for a separator.
    pub backslashes: Vec<String>,
    /// Links, of which the importer makes texts.
    pub links: Vec<String>,
    /// Members that others of the same name replace.
    pub replaced: Vec<String>,
}

/// Where an importer puts the files of a pack.
#[derive(Debug, Clone, Default)]
pub struct Import {
    /// The base mesh that it is imported for.
    pub base: String,
    /// Paths below the data root by paths in the pack, of all files; `None` for what is ignored.
    pub places: BTreeMap<String, Option<String>>,
    /// Paths in the pack that come to the same path below the data root and differ in content, by
    /// that path.
    pub overwritten: BTreeMap<String, BTreeSet<String>>,
}

impl Import {
    /// The file of the pack that a name in another one leads to before they are imported. `from` is
    /// the path in the pack of the file with the name.
    pub fn meant(&self, from: &str, text: &str) -> Option<&str> {
        let known = |place: String| {
            self.places
                .get_key_value(&place)
                .map(|(path, _)| path.as_str())
        };
        named_places(from, text).find_map(known)
    }
}

impl Pack {
    /// Members that the applications can unpack and this program cannot.
    pub fn unread(&self) -> impl Iterator<Item = &str> {
        let faults = self.faults.iter().flat_map(|facts| &facts.faults);
        faults
            .filter(|(_, fault)| fault.is_of_reader())
            .map(|(name, _)| name.as_str())
    }

    /// Whether there is a file at a path in the pack that importing ignores.
    pub fn ignores(&self, path: &str) -> bool {
        self.import
            .as_ref()
            .is_some_and(|import| import.places.get(path).is_some_and(Option::is_none))
    }

    /// Whether a name leads to something in the pack that is not there once it is unpacked or
    /// imported, for a reason that is a fault of the pack. `from` is a file of the layer at `root`.
    pub fn explains(&self, root: &str, from: &FileFacts, text: &str) -> bool {
        let Some(from) = from
            .path
            .strip_prefix(root)
            .map(|from| from.trim_start_matches('/'))
        else {
            return false;
        };
        let is_moved = || {
            self.import
                .as_ref()
                .is_some_and(|import| import.meant(from, text).is_some())
        };
        named_places(from, text).any(|place| self.lost.contains(&place)) || is_moved()
    }
}

/// Where the files around another one are looked for.
fn named_places(from: &str, text: &str) -> impl Iterator<Item = String> {
    let own = parent(from);
    let above = own
        .ends_with("materials")
        .then(|| format!("{}/{text}", parent(own)));
    let below = text
        .split_once('/')
        .map(|(_, below)| format!("{own}/{below}"));
    [Some(format!("{own}/{text}")), above, below]
        .into_iter()
        .flatten()
        .filter_map(|place| normalized(&place))
}
