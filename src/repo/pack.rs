//! A zip that is checked as the folder it becomes: what is wrong with the zip, and what its import does to paths.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::{FileFacts, parent};
use crate::source::{PackFacts, normalized};

/// A zip that a layer was made of.
#[derive(Debug, Clone, Default)]
pub(crate) struct Pack {
    /// What is wrong with the zip; nothing where another layer of it has that.
    pub faults: Option<Arc<PackFacts>>,
    /// What becomes of its files, where they are not just unpacked.
    pub import: Option<Import>,
}

/// Where an importer puts the files of a pack.
#[derive(Debug, Clone, Default)]
pub(crate) struct Import {
    /// The base mesh that it is imported for.
    pub base: String,
    /// Paths below the data root by paths in the pack, of all files; `None` for what is ignored.
    pub places: BTreeMap<String, Option<String>>,
    /// Paths in the pack that come to the same path below the data root and differ in content, by that path.
    pub overwritten: BTreeMap<String, BTreeSet<String>>,
    /// Names that are read with other letters than they were written with, by path in the pack.
    pub misread: BTreeMap<String, String>,
    /// Paths whose names have `\\` for a separator.
    pub backslashes: Vec<String>,
    /// Links, of which the importer makes texts.
    pub links: Vec<String>,
    /// Members that others of the same name replace.
    pub replaced: Vec<String>,
}

impl Import {
    /// The file of the pack that a name in another one leads to before they are imported. `from` is the path in the pack of
    /// the file with the name.
    pub(crate) fn meant(&self, from: &str, text: &str) -> Option<&str> {
        let own = parent(from);
        let above = own.ends_with("materials").then(|| parent(own));
        let below = text.split_once('/').map(|(_, below)| format!("{own}/{below}"));
        let places = [Some(format!("{own}/{text}")), above.map(|above| format!("{above}/{text}")), below];
        let known = |place: String| self.places.get_key_value(&normalized(&place)?).map(|(path, _)| path.as_str());
        places.into_iter().flatten().find_map(known)
    }
}

impl Pack {
    /// Whether a name leads to a file of the pack that the importer puts elsewhere, or under another name. `from` is a file
    /// of the layer at `root`.
    pub(crate) fn moves(&self, root: &str, from: &FileFacts, text: &str) -> bool {
        let Some(import) = &self.import else { return false };
        let from = from.path.strip_prefix(root).map(|from| from.trim_start_matches('/'));
        from.is_some_and(|from| import.meant(from, text).is_some())
    }
}
