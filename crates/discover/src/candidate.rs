//! Every path of a data root, with what each application uses the file there for. It is worked out
//! once.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::{Kind, Layout, Role};
use mhlint_diag::Application;
use mhlint_source::{Entry, EntryKind, Tree, folder_and_name, inside, is_below};

/// What one application uses a file for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Use {
    /// The application.
    pub application: Application,
    /// The kind of file that it is to the application.
    pub kind: Kind,
    /// The base mesh that it belongs to.
    pub owner: Option<String>,
}

/// A file or folder below a data root. A folder has the kind that a file at its path would have.
#[derive(Debug, Clone)]
pub struct Candidate<'t> {
    /// Where to read it.
    pub entry: &'t Entry,
    /// Its path below the root; a loose file has only a supposed one.
    pub rel: Cow<'t, str>,
    /// Whether `rel` is only a supposed path, because the file lies in no data root.
    pub is_loose: bool,
    /// What each application uses it for, of those whose data root this is.
    pub uses: Vec<Use>,
}

/// The kind that a file is read as. If its uses have several kinds, this is the kind that says most
/// about the file, which `Kind` lists first.
pub(crate) fn kind_of(uses: &[Use]) -> Kind {
    uses.iter().map(|one| one.kind).min().unwrap_or(Kind::Other)
}

/// The base mesh that a file belongs to, in the use that gives the kind as which it is read.
pub fn owner_of(uses: &[Use]) -> Option<&str> {
    uses.iter()
        .min_by_key(|one| (one.kind, one.owner.is_none()))?
        .owner
        .as_deref()
}

/// The kind of a file to one application; `Kind::Other` if the application has no use for it.
pub fn kind_in(uses: &[Use], application: Application) -> Kind {
    uses.iter()
        .find(|one| one.application == application)
        .map_or(Kind::Other, |one| one.kind)
}

/// What a path below a data root with these layouts is for.
pub fn uses_of(rel: &str, layouts: &[&Layout]) -> Vec<Use> {
    layouts.iter().map(|layout| layout.use_of(rel)).collect()
}

/// The folder that macOS adds to a zip. No application reads it.
const OF_MACOS: &str = "__MACOSX";

/// Whether a path lies in the folder that macOS adds to a zip.
pub fn is_of_macos(path: &str) -> bool {
    path.split('/').any(|part| part == OF_MACOS)
}

/// Every file and folder in `tree` below `root`, which is a data root of the applications of
/// `layouts`; and the files beside `root` that belong to it.
pub fn candidates<'t>(tree: &'t Tree, root: &str, layouts: &[&Layout]) -> Vec<Candidate<'t>> {
    let entries = tree.entries_in(root).iter();
    let entries = entries.filter_map(|entry| Some((entry, inside(&entry.path, root)?)));
    let entries = entries.filter(|(_, rel)| !is_below(rel, OF_MACOS));
    // The tree may list hidden files that only other applications read.
    let is_taken = |entry: &Entry| {
        layouts
            .iter()
            .any(|layout| layout.takes(&entry.path, root.len(), entry.kind == EntryKind::Folder))
    };
    let entries = entries.filter(|(entry, _)| is_taken(entry));
    let mut found: Vec<Candidate<'t>> = entries
        .map(|(entry, rel)| Candidate::new(entry, rel, layouts))
        .collect();
    // Files beside a data folder belong to it only in a user's folder. That includes a user's
    // folder into which somebody copied the data of the program.
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

/// Adds the files beside a data folder that belong to it, each file once. If the data folder has a
/// file at the same path, that file counts. Models are the exception: they belong beside the data
/// folder, so that a model inside it is in the wrong place.
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

/// The files beside a data root that belong to it, most of them in folders. Files that the
/// application has no use for belong to somebody else and are left out.
fn beside<'t>(tree: &'t Tree, root: &str, layout: &Layout) -> Vec<Candidate<'t>> {
    let (above, name) = folder_and_name(root);
    let folders = layout.beside.iter().filter(|_| name == "data");
    let of_folder = |folder: &&str| {
        let path = if above.is_empty() {
            (*folder).to_owned()
        } else {
            format!("{above}/{folder}")
        };
        let below = tree.entry(&path).into_iter().chain(tree.entries_in(&path));
        let below = below.filter(|entry| entry.kind != EntryKind::Folder);
        // `beside` may name a file in place of a folder. A file of the same name in the data folder
        // means nothing, so that this one gets a path of its own.
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
    /// A candidate at `rel`, with what each of the applications uses it for.
    fn new(entry: &'t Entry, rel: &'t str, layouts: &[&Layout]) -> Self {
        Self {
            entry,
            rel: rel.into(),
            is_loose: false,
            uses: uses_of(rel, layouts),
        }
    }

    /// A candidate for a loose file; `rel` is the supposed path that it was given.
    pub(super) fn loose(entry: &'t Entry, rel: String, layout: &Layout) -> Self {
        let uses = uses_of(&rel, &[layout]);
        Self {
            entry,
            rel: rel.into(),
            is_loose: true,
            uses,
        }
    }

    /// A candidate for a file of a pack; `rel` is the path at which the importer puts it. If that
    /// differs from the path in the pack, findings show the path in the pack.
    pub fn imported(entry: &'t Entry, rel: String, layout: &Layout) -> Self {
        Self {
            is_loose: !entry.path.ends_with(&rel),
            ..Self::loose(entry, rel, layout)
        }
    }

    /// The kind of file that it is read as.
    pub fn kind(&self) -> Kind {
        kind_of(&self.uses)
    }

    /// The kind of file that it is to one application.
    pub(super) fn kind_in(&self, application: Application) -> Kind {
        kind_in(&self.uses, application)
    }

    /// The base mesh that it belongs to, in the use that gives the kind as which it is read.
    pub fn owner(&self) -> Option<&str> {
        owner_of(&self.uses)
    }

    /// Whether it can be read as a file, as far as the listing tells.
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
