//! Every path of a data root with what it is for, found out once.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::{Kind, Layout, Role};
use mhlint_diag::Application;
use mhlint_source::{Entry, EntryKind, Tree, inside, is_below};

/// What one application has a file for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Use {
    /// Whose use it is.
    pub application: Application,
    /// What it is for.
    pub kind: Kind,
    /// The base mesh that it belongs to.
    pub owner: Option<String>,
}

/// Something below a data root. A folder is what a file in its place would be.
#[derive(Debug, Clone)]
pub struct Candidate<'t> {
    /// Where to read it.
    pub entry: &'t Entry,
    /// Its path below the root; a loose file has only a supposed one.
    pub rel: Cow<'t, str>,
    /// Whether that is only supposed, because it lies in no data root.
    pub is_loose: bool,
    /// What it is for, to each application whose data root it is.
    pub uses: Vec<Use>,
}

/// The kind that a file is read as: of those that its uses give it the one that says most, which
/// comes first.
pub(crate) fn kind_of(uses: &[Use]) -> Kind {
    uses.iter().map(|one| one.kind).min().unwrap_or(Kind::Other)
}

/// The base mesh that a file belongs to as what it is read as.
pub fn owner_of(uses: &[Use]) -> Option<&str> {
    uses.iter()
        .min_by_key(|one| (one.kind, one.owner.is_none()))?
        .owner
        .as_deref()
}

/// What a file is for to one application; anything to those that have no use for it.
pub fn kind_in(uses: &[Use], application: Application) -> Kind {
    uses.iter()
        .find(|one| one.application == application)
        .map_or(Kind::Other, |one| one.kind)
}

/// What a path below a data root with these layouts is for.
pub fn uses_of(rel: &str, layouts: &[&Layout]) -> Vec<Use> {
    layouts.iter().map(|layout| layout.use_of(rel)).collect()
}

/// What macOS puts beside the files of a zip: no application looks for it.
const OF_MACOS: &str = "__MACOSX";

/// Whether a path lies in what macOS puts beside the files of a zip.
pub fn is_of_macos(path: &str) -> bool {
    path.split('/').any(|part| part == OF_MACOS)
}

/// Everything in `tree` below `root`, the data root of the applications that `layouts` are of, and
/// what belongs to it beside it.
pub fn candidates<'t>(tree: &'t Tree, root: &str, layouts: &[&Layout]) -> Vec<Candidate<'t>> {
    let entries = tree.entries_in(root).iter();
    let entries = entries.filter_map(|entry| Some((entry, inside(&entry.path, root)?)));
    let entries = entries.filter(|(_, rel)| !is_below(rel, OF_MACOS));
    // What is hidden from these applications may be listed for the sake of others.
    let is_taken = |entry: &Entry| {
        layouts
            .iter()
            .any(|layout| layout.takes(&entry.path, root.len(), entry.kind == EntryKind::Folder))
    };
    let entries = entries.filter(|(entry, _)| is_taken(entry));
    let mut found: Vec<Candidate<'t>> = entries
        .map(|(entry, rel)| Candidate::new(entry, rel, layouts))
        .collect();
    // Only a user has something of his own there, also one over whose data those of the program
    // were copied.
    let own = found.len();
    let users = layouts.iter().filter_map(|layout| {
        found.truncate(own);
        found.extend(beside(tree, root, layout));
        let is_user = found.len() > own && (layout.role)(&found) != Role::System;
        is_user.then(|| found.split_off(own))
    });
    let all: Vec<Candidate<'t>> = users.collect::<Vec<_>>().concat();
    found.truncate(own);
    if !all.is_empty() {
        add_around(&mut found, all, layouts);
    }
    found
}

/// Adds what belongs to a data folder beside it, each file once. What is in the folder itself comes
/// first, but for models, which lie beside it: those in it have no place.
fn add_around<'t>(found: &mut Vec<Candidate<'t>>, all: Vec<Candidate<'t>>, layouts: &[&Layout]) {
    let own: BTreeMap<String, usize> = found
        .iter()
        .enumerate()
        .map(|(at, one)| (one.rel.to_string(), at))
        .collect();
    let mut around: BTreeMap<String, Candidate<'t>> = BTreeMap::new();
    for one in all {
        match own.get(&*one.rel).and_then(|at| found.get_mut(*at)) {
            Some(misplaced) if one.kind() == Kind::Model => {
                let rel = format!("data/{}", one.rel);
                misplaced.uses = uses_of(&rel, layouts);
                misplaced.rel = rel.into();
            }
            Some(_) => continue,
            None => {}
        }
        let (rel, uses) = (one.rel.to_string(), one.uses.clone());
        around
            .entry(rel)
            .and_modify(|known| known.uses.extend(uses))
            .or_insert(one);
    }
    found.extend(around.into_values());
}

/// The files that an application has beside its data root, most of them in folders. What it has no
/// use for is somebody else's.
fn beside<'t>(tree: &'t Tree, root: &str, layout: &Layout) -> Vec<Candidate<'t>> {
    let (above, name) = root.rsplit_once('/').unwrap_or(("", root));
    let folders = layout.beside.iter().filter(|_| name == "data");
    let of_folder = |folder: &&str| {
        let path = if above.is_empty() {
            (*folder).to_owned()
        } else {
            format!("{above}/{folder}")
        };
        let below = tree.entry(&path).into_iter().chain(tree.entries_in(&path));
        let below = below.filter(|entry| entry.kind != EntryKind::Folder);
        // A file of that name belongs to it as well. In the data folder the same name means
        // nothing.
        let rel = |entry: &Entry| match inside(&entry.path, &path) {
            Some(rel) => Some(format!("{folder}/{rel}")),
            None => (entry.path == path).then(|| format!("../{folder}")),
        };
        let files = below.filter_map(|entry| Some((entry, rel(entry)?)));
        let candidates = files.map(|(entry, rel)| Candidate::loose(entry, rel, layout));
        candidates
            .filter(|one| one.kind() != Kind::Other)
            .collect::<Vec<_>>()
    };
    folders.flat_map(of_folder).collect()
}

impl<'t> Candidate<'t> {
    /// Finds out what `rel` is for.
    fn new(entry: &'t Entry, rel: &'t str, layouts: &[&Layout]) -> Self {
        Self {
            entry,
            rel: rel.into(),
            is_loose: false,
            uses: uses_of(rel, layouts),
        }
    }

    /// The same for the place that a loose file is put to.
    pub(super) fn loose(entry: &'t Entry, rel: String, layout: &Layout) -> Self {
        let uses = uses_of(&rel, &[layout]);
        Self {
            entry,
            rel: rel.into(),
            is_loose: true,
            uses,
        }
    }

    /// The same for the place that an importer puts a file of a pack to; where that is another one,
    /// it is shown where it lies.
    pub fn imported(entry: &'t Entry, rel: String, layout: &Layout) -> Self {
        Self {
            is_loose: !entry.path.ends_with(&rel),
            ..Self::loose(entry, rel, layout)
        }
    }

    /// The kind that it is read as.
    pub fn kind(&self) -> Kind {
        kind_of(&self.uses)
    }

    /// What it is for to one application.
    pub(super) fn kind_in(&self, application: Application) -> Kind {
        kind_in(&self.uses, application)
    }

    /// The base mesh that it belongs to as what it is read as.
    pub fn owner(&self) -> Option<&str> {
        owner_of(&self.uses)
    }

    /// Whether it is to be read, as far as the listing can tell.
    pub fn is_file(&self) -> bool {
        self.entry.kind != EntryKind::Folder
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_file_has_a_use_for_each_application() {
        let tree = Tree::in_memory("", [("data/clothes/hm08/a/a.mhclo".to_owned(), Vec::new())]);
        let layouts = Application::ALL.map(Layout::of);
        let found = candidates(&tree, "data", &layouts);
        let file = found.iter().find(|one| one.is_file()).unwrap();
        assert_eq!(
            (&*file.rel, file.kind(), file.owner()),
            ("clothes/hm08/a/a.mhclo", Kind::Clothes, Some("hm08"))
        );
        assert_eq!(
            file.uses
                .iter()
                .map(|one| one.application)
                .collect::<Vec<_>>(),
            Application::ALL
        );
        assert!(candidates(&tree, "dat", &layouts).is_empty());
    }
}
