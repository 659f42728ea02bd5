//! A data root in its tree: what lies in it, and what each file is for.

use std::collections::{BTreeMap, BTreeSet};

use super::narrow::Narrow;
use mhlint_diag::{Application, grouped};
use mhlint_discover::{Candidate, Known, Layout, Role, Use, candidates, loose};
use mhlint_formats::Format;
use mhlint_formats::Needs;
use mhlint_repo::Pack;
use mhlint_source::{Tree, is_below_any};

/// A data root in its tree.
pub(crate) struct Place<'t> {
    pub(crate) tree: &'t Tree,
    /// Path from the top of the tree.
    pub(super) root: String,
    /// The layouts that it has.
    pub(super) layouts: Vec<&'static Layout>,
    /// Whether it is no data root at all, but files that would belong into one.
    pub(super) is_loose: bool,
    /// Data roots of other applications inside it.
    inner: BTreeSet<String>,
    /// Whether it is a data root of other applications as well, which have it as another place.
    is_shared: bool,
    /// The zip that it is in, if it is in one.
    pub(super) pack: Option<Pack>,
    /// Everything in it.
    pub(super) below: Vec<Candidate<'t>>,
    /// Places among those of the bulk of each base mesh, which is read in turn; `None` for that of
    /// no base mesh.
    bulk: BTreeMap<Option<String>, Vec<usize>>,
}

impl<'t> Place<'t> {
    /// The data root at `root` with these layouts.
    pub(crate) fn new(tree: &'t Tree, root: &str, layouts: &[&'static Layout]) -> Self {
        Self::around(tree, root, layouts, BTreeSet::new())
    }

    /// The data root at `root`, without those of other applications inside it.
    pub(super) fn around(
        tree: &'t Tree,
        root: &str,
        layouts: &[&'static Layout],
        inner: BTreeSet<String>,
    ) -> Self {
        let mut below = candidates(tree, root, layouts);
        if !inner.is_empty() {
            leave_out(&mut below, &inner, layouts);
        }
        Self {
            inner,
            ..Self::with(tree, root, layouts, below, false)
        }
    }

    /// The loose files of a tree, as if they lay in a user's data root of `layout`, with those
    /// printed paths that alone are asked for: with a file it is what belongs to that.
    pub(super) fn loose(
        tree: &'t Tree,
        layout: &'static Layout,
        known: &Known<'_>,
        narrow: &Narrow,
    ) -> (Self, Narrow) {
        let loose = loose(tree, layout, known);
        let files = narrow
            .paths()
            .iter()
            .filter_map(|path| tree.entry(tree.below(path)?));
        let parts = loose.belonging_to(files.map(|file| file.path.as_str()));
        let parts = parts.into_iter().map(|path| tree.shown(path));
        let parts = Narrow::to(narrow.paths().iter().cloned().chain(parts).collect());
        (Self::with(tree, "", &[layout], loose.files, true), parts)
    }

    /// These files of a zip, with the paths that they get.
    pub(super) fn of_pack(
        tree: &'t Tree,
        root: &str,
        layouts: &[&'static Layout],
        below: Vec<Candidate<'t>>,
        pack: Pack,
    ) -> Self {
        Self {
            pack: Some(pack),
            ..Self::with(tree, root, layouts, below, false)
        }
    }

    fn with(
        tree: &'t Tree,
        root: &str,
        layouts: &[&'static Layout],
        below: Vec<Candidate<'t>>,
        is_loose: bool,
    ) -> Self {
        let bulk = below.iter().enumerate().filter(|(_, file)| is_bulk(file));
        let bulk = grouped(bulk.map(|(number, file)| (file.owner().map(str::to_owned), number)))
            .into_iter()
            .collect();
        Self {
            tree,
            root: root.to_owned(),
            layouts: layouts.to_vec(),
            is_loose,
            is_shared: false,
            inner: BTreeSet::new(),
            pack: None,
            below,
            bulk,
        }
    }

    /// Whether its files lie in no data root yet: each application would have them at a place of
    /// its own.
    pub(super) const fn is_supposed(&self) -> bool {
        self.is_loose || self.pack.is_some()
    }

    /// Whether other applications may have the same files in a place of their own.
    pub(crate) const fn is_one_of_several(&self) -> bool {
        self.is_supposed() || self.is_shared
    }

    /// What is equal for places that have the same files, for other applications; `None` where no
    /// other one has them.
    pub(super) fn files_key(&self) -> Option<(*const Tree, Option<&str>)> {
        let root = (!self.is_supposed()).then_some(self.root.as_str());
        self.is_one_of_several()
            .then_some((std::ptr::from_ref(self.tree), root))
    }

    /// Path of the root as reports print it.
    pub(crate) fn path(&self) -> String {
        self.tree.shown(&self.root)
    }

    /// The same as one application alone has it.
    pub(super) fn of_one(&self, application: Application) -> Self {
        let own = [Layout::of(application)];
        Self {
            is_shared: true,
            ..Self::around(self.tree, &self.root, &own, self.inner.clone())
        }
    }

    /// Whether it is a data root of an application.
    pub(super) fn is_of(&self, application: Application) -> bool {
        self.layouts
            .iter()
            .any(|layout| layout.application == application)
    }

    /// Whether it is all that a program has, where it is a program's; the second says which base
    /// meshes other data of that have.
    pub(super) fn stands_alone(
        &self,
        application: Application,
        bases: impl Fn(&str) -> bool,
    ) -> bool {
        !self.is_supposed() && (Layout::of(application).stands_alone)(&self.below, &bases)
    }

    /// What is equal for two data roots of the same applications at the same path.
    pub(crate) fn key(&self) -> PlaceKey {
        let applications = self.layouts.iter().map(|layout| layout.application);
        (self.path(), applications.collect())
    }

    /// The base meshes that something in it belongs to.
    pub(super) fn owners(&self) -> BTreeSet<&str> {
        let uses = self.below.iter().flat_map(|one| &one.uses);
        uses.filter_map(|one| one.owner.as_deref()).collect()
    }

    /// Its files but for the bulk.
    pub(super) fn files(&self) -> impl Iterator<Item = &Candidate<'t>> {
        self.below
            .iter()
            .filter(|file| file.is_file() && !is_bulk(file))
    }

    /// Everything that is read in turn.
    pub(super) fn bulk(&self) -> impl Iterator<Item = &Candidate<'t>> {
        self.below.iter().filter(|file| is_bulk(file))
    }

    /// What is read in the turn of a base mesh; `None` for what belongs to none.
    pub(crate) fn bulk_of(&self, base: Option<&str>) -> impl Iterator<Item = &Candidate<'t>> {
        let numbers = self
            .bulk
            .get(&base.map(str::to_owned))
            .into_iter()
            .flatten();
        numbers.filter_map(|number| self.below.get(*number))
    }

    /// Names of the bases that have targets here.
    pub(crate) fn target_bases(&self) -> BTreeSet<Option<&str>> {
        self.bulk.keys().map(Option::as_deref).collect()
    }
}

/// Path and applications of a data root.
pub(crate) type PlaceKey = (String, Vec<Application>);

/// Takes the data roots of other applications out of one around them, but for what an application
/// looks for everywhere in its own data, and what is dangerous to it.
fn leave_out(
    below: &mut Vec<Candidate<'_>>,
    inner: &BTreeSet<String>,
    layouts: &[&'static Layout],
) {
    let systems = layouts
        .iter()
        .filter(|layout| (layout.role)(below) != Role::User);
    let everywhere: Vec<_> = systems
        .filter_map(|layout| Some((layout.application, layout.everywhere?)))
        .collect();
    below.retain_mut(|one| {
        let path = &one.entry.path;
        if is_below_any(path, inner) {
            let is_dangerous = |one: &Use| (Layout::of(one.application).is_dangerous)(path);
            one.uses.retain(|one| {
                everywhere.contains(&(one.application, one.kind)) || is_dangerous(one)
            });
        }
        !one.uses.is_empty()
    });
}

fn is_bulk(file: &Candidate<'_>) -> bool {
    file.is_file() && Format::of(file.kind()).needs == Needs::MeshInTurn
}
