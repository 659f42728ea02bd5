//! Data roots: where they are in the inputs, and which of them are judged.

use std::collections::BTreeSet;

use super::super::error::{Error, PathFault};
use super::super::settle::Scope;
use super::input::Input;
use super::layer::Place;
use super::loose::Moved;
use crate::config::Config;
use crate::diag::{Application, EXAMPLES, NotChecked, Note, Outcome, RootSummary, Unchecked};
use crate::discover::{DataRoot, find_roots};
use crate::repo::Repository;
use crate::source::{Entry, EntryKind, Tree};

/// The data roots of a run.
pub(in crate::engine) struct Roots<'t> {
    inputs: &'t [Input],
    /// Those of each input.
    pub(in crate::engine) found: Vec<Vec<DataRoot>>,
    system: Option<(&'t Tree, Vec<DataRoot>)>,
}

/// The data roots in a tree.
pub(in crate::engine) fn roots_of(tree: &Tree) -> Vec<DataRoot> {
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    find_roots(files.map(|entry| entry.path.as_str()))
}

impl<'t> Roots<'t> {
    /// Looks for them.
    pub(in crate::engine) fn of(inputs: &'t [Input], system: Option<&'t Tree>) -> Self {
        let found = inputs.iter().map(|input| roots_of(&input.tree)).collect();
        Self { inputs, found, system: system.map(|tree| (tree, roots_of(tree))) }
    }

    /// The data root of `--system`, unless it is all there is to judge.
    pub(in crate::engine) fn system_place(&self, outcome: &mut Outcome) -> Result<Option<Place<'_>>, Error> {
        let Some((tree, roots)) = &self.system else { return Ok(None) };
        let root = roots.iter().find(|root| root.application == Application::Makehuman2);
        let root = root.ok_or_else(|| Error::Path {
            path: tree.label().to_owned(),
            fault: PathFault::NoDataOf(Application::Makehuman2),
        })?;
        let place = Place { tree, root: &root.path, moved: None };
        let path = place.path();
        if self.is_all_there_is(&path) {
            outcome.notes.push(Note::SystemIsChecked { path: shown(&path).to_owned() });
            return Ok(None);
        }
        Ok(Some(place))
    }

    /// Every data root with its input.
    fn all(&self) -> impl Iterator<Item = (&'t Input, &DataRoot, Place<'_>)> {
        self.inputs.iter().zip(&self.found).flat_map(|(input, roots)| {
            roots.iter().map(move |root| (input, root, Place { tree: &input.tree, root: &root.path, moved: None }))
        })
    }

    /// Whether the system data are the only data root that was given to be judged.
    fn is_all_there_is(&self, system: &str) -> bool {
        let mut paths = self.all().map(|(_, _, place)| place.path()).peekable();
        paths.peek().is_some() && paths.all(|given| given == system)
    }

    /// What to judge, with what to report of each: data roots and, as `moved` has them, files outside of any.
    pub(in crate::engine) fn places<'p>(
        &'p self,
        moved: &'p [Moved],
        system: Option<Place<'_>>,
        scope: &Scope<'_>,
        options: &Config,
        outcome: &mut Outcome,
    ) -> Vec<(Place<'p>, Vec<String>)> {
        let system = system.map(Place::path);
        let mut wanted = Vec::new();
        for (input, root, place) in self.all() {
            let path = place.path();
            if scope.excludes(&path) || system.as_ref() == Some(&path) || !options.asks_for(root.application) {
                continue;
            }
            if root.application == Application::Makehuman2 {
                want(&mut wanted, place, &input.narrow);
            } else {
                note_unchecked(place, root.application, outcome);
            }
        }
        for (input, moved) in self.inputs.iter().zip(moved).filter(|(_, moved)| !moved.is_empty()) {
            if options.asks_for(Application::Makehuman2) {
                want(&mut wanted, Place { tree: &input.tree, root: "", moved: Some(moved) }, &input.narrow);
            }
        }
        wanted
    }
}

/// A root that two PATHs lead to is judged once, for everything that either asks for.
fn want<'t>(wanted: &mut Vec<(Place<'t>, Vec<String>)>, place: Place<'t>, narrow: &[String]) {
    match wanted.iter_mut().find(|(known, _)| known.path() == place.path()) {
        Some((_, known)) if known.is_empty() || narrow.is_empty() => known.clear(),
        Some((_, known)) => known.extend_from_slice(narrow),
        None => wanted.push((place, narrow.to_vec())),
    }
}

fn note_unchecked(place: Place<'_>, application: Application, outcome: &mut Outcome) {
    let root = place.path();
    let path = shown(&root).to_owned();
    let files: Vec<&Entry> = place.files().map(|(file, _)| file).collect();
    outcome.not_checked.push(NotChecked {
        application: Some(application),
        what: Unchecked::Application,
        count: files.len(),
        examples: files.iter().take(EXAMPLES).map(|file| place.printed(file)).collect(),
    });
    outcome.notes.push(Note::NotYet { path: path.clone(), application });
    outcome.roots.push(RootSummary { path, application, bases: Vec::new(), checked: false });
}

/// Says that a repository was judged, and which base meshes it has.
pub(in crate::engine) fn summarise(repository: &Repository<'_>, outcome: &mut Outcome) {
    let judged = repository.judged;
    let own = |name: &str| judged.files.values().any(|file| file.base.as_deref() == Some(name));
    let bases = repository.bases.iter().map(|base| base.name).filter(|name| own(name));
    outcome.roots.push(RootSummary {
        path: shown(&judged.path).to_owned(),
        application: repository.application,
        bases: bases.map(str::to_owned).collect(),
        checked: true,
    });
}

/// Refuses `--base` with a name that no data root has.
pub(in crate::engine) fn check_bases(options: &Config, outcome: &Outcome) -> Result<(), Error> {
    let known: BTreeSet<&String> = outcome.roots.iter().flat_map(|root| &root.bases).collect();
    let unknown = options.bases.iter().find(|name| !known.contains(name));
    unknown.filter(|_| outcome.checked_anything()).map_or(Ok(()), |name| {
        Err(Error::UnknownBase { name: name.clone(), known: known.into_iter().cloned().collect() })
    })
}

fn shown(path: &str) -> &str {
    if path.is_empty() { "." } else { path }
}
