//! Data roots: where they are in the inputs, and which of them are checked.

use std::collections::{BTreeMap, BTreeSet};

use super::super::catalogue::CHECKED;
use super::super::error::{Error, PathFault};
use super::super::settle::Scope;
use super::input::Input;
use super::place::Place;
use crate::config::Config;
use crate::diag::{Application, EXAMPLES, NotChecked, Note, Outcome, RootSummary, Unchecked};
use crate::discover::{Kind, Layout, find_roots};
use crate::source::{EntryKind, Tree};

/// What a run reads.
pub(in crate::engine) struct Roots<'t> {
    /// What to check, with the parts that alone are asked for.
    pub(in crate::engine) checked: Vec<(Place<'t>, Vec<String>)>,
    /// `--system`, unless it is all there is to check.
    pub(in crate::engine) system: Option<Place<'t>>,
}

/// The data roots in a tree of the applications of which `wanted` holds, by path.
pub(super) fn roots_of(tree: &Tree, wanted: impl Fn(Application) -> bool) -> BTreeMap<String, Vec<&'static Layout>> {
    let files = tree.entries().iter().filter(|entry| entry.kind == EntryKind::File);
    let mut roots: BTreeMap<String, Vec<_>> = BTreeMap::new();
    for root in find_roots(files.map(|entry| entry.path.as_str())).into_iter().filter(|root| wanted(root.application)) {
        roots.entry(root.path).or_default().push(Layout::of(root.application));
    }
    roots
}

/// The data roots in a tree of the applications that are checked.
pub(super) fn checked_places<'t>(tree: &'t Tree, applications: &[Application]) -> Vec<Place<'t>> {
    let roots = roots_of(tree, |application| applications.contains(&application));
    roots.into_iter().map(|(path, layouts)| Place::new(tree, &path, &layouts)).collect()
}

impl<'t> Roots<'t> {
    /// Looks for them: data roots, and files outside of any.
    pub(in crate::engine) fn of(
        inputs: &'t [Input],
        system: Option<&'t Tree>,
        scope: &Scope<'_>,
        options: &Config,
        applications: &[Application],
        outcome: &mut Outcome,
    ) -> Result<Self, Error> {
        let found: Vec<_> = inputs.iter().map(|input| (input, roots_of(&input.tree, |_| true))).collect();
        let mut system = system.map(|system| system_place(system, applications)).transpose()?;
        let bases = system.as_ref().map(base_meshes).unwrap_or_default();
        let mut given = found.iter().flat_map(|(input, roots)| roots.keys().map(|root| input.tree.shown(root)));
        let all_given = given.next().filter(|first| given.all(|other| other == *first));
        if let Some(all) = system.take_if(|system| all_given == Some(system.path())) {
            outcome.notes.push(Note::SystemIsChecked { path: shown(&all.path()).to_owned() });
        }
        let outside = found.iter().filter(|(_, roots)| roots.is_empty()).map(|(input, _)| *input);
        let loose = loose(outside.collect(), &bases, options, applications, outcome);
        let below = system.as_ref().map(Place::path);
        let mut roots = Self { checked: Vec::new(), system };
        for (input, (path, layouts)) in
            found.iter().flat_map(|(input, roots)| roots.iter().map(move |one| (*input, one)))
        {
            let shown = input.tree.shown(path);
            if !scope.excludes(&shown) && below.as_ref() != Some(&shown) {
                let asked = layouts.iter().copied().filter(|layout| options.asks_for(layout.application));
                let (checked, others) = asked.partition(|layout| applications.contains(&layout.application));
                roots.add(input, path, [checked, others], outcome);
            }
        }
        for (input, place) in loose {
            roots.want(place, &input.narrow);
        }
        Ok(roots)
    }

    /// A data root with the layouts that are asked for: of applications that are checked, and of others.
    fn add(
        &mut self,
        input: &'t Input,
        path: &str,
        [checked, others]: [Vec<&'static Layout>; 2],
        outcome: &mut Outcome,
    ) {
        if !checked.is_empty() {
            self.want(Place::new(&input.tree, path, &checked), &input.narrow);
        }
        for layout in others {
            note_unchecked(&Place::new(&input.tree, path, &[layout]), layout, outcome);
        }
    }

    /// A root that two PATHs lead to is checked once, for everything that either asks for.
    fn want(&mut self, place: Place<'t>, narrow: &[String]) {
        match self.checked.iter_mut().find(|(known, _)| known.path() == place.path()) {
            Some((_, known)) if known.is_empty() || narrow.is_empty() => known.clear(),
            Some((_, known)) => known.extend_from_slice(narrow),
            None => self.checked.push((place, narrow.to_vec())),
        }
    }
}

/// The data root of `--system`.
fn system_place<'t>(tree: &'t Tree, applications: &[Application]) -> Result<Place<'t>, Error> {
    let [wanted, ..] = CHECKED;
    let nothing = || Error::Path { path: tree.label().to_owned(), fault: PathFault::NoDataOf(wanted) };
    checked_places(tree, applications).into_iter().next().ok_or_else(nothing)
}

/// The files of trees without a data root, put where the applications would look for them.
fn loose<'t>(
    outside: Vec<&'t Input>,
    bases: &BTreeSet<String>,
    options: &Config,
    applications: &[Application],
    outcome: &mut Outcome,
) -> Vec<(&'t Input, Place<'t>)> {
    let base = base_for(bases, options);
    let place = |input: &'t Input, one| (input, one, Place::loose(&input.tree, Layout::of(one), base));
    let places = outside.into_iter().flat_map(|input| applications.iter().map(move |one| place(input, *one)));
    let places: Vec<_> = places.filter(|(_, _, place)| !place.is_empty()).collect();
    if base.is_none() && !places.is_empty() {
        outcome.notes.push(Note::Alone { bases: bases.iter().cloned().collect() });
    }
    let asked = places.into_iter().filter(|(_, application, _)| options.asks_for(*application));
    asked.map(|(input, _, place)| (input, place)).collect()
}

/// The base mesh that loose files are for: the one asked for, or the only one there is.
fn base_for<'b>(bases: &'b BTreeSet<String>, options: &Config) -> Option<&'b str> {
    match options.bases.as_slice() {
        [asked] => bases.get(asked),
        _ if bases.len() == 1 => bases.first(),
        _ => None,
    }
    .map(String::as_str)
}

fn base_meshes(place: &Place<'_>) -> BTreeSet<String> {
    let meshes = place.files().filter(|file| file.kind() == Kind::BaseMesh);
    meshes.filter_map(|file| file.owner().map(str::to_owned)).collect()
}

fn note_unchecked(place: &Place<'_>, layout: &Layout, outcome: &mut Outcome) {
    let (root, application) = (place.path(), layout.application);
    let path = shown(&root).to_owned();
    let files: Vec<_> = place.below.iter().filter(|file| file.is_file()).collect();
    outcome.not_checked.push(NotChecked {
        application: Some(application),
        what: Unchecked::Application,
        count: files.len(),
        examples: files.iter().take(EXAMPLES).map(|file| place.tree.shown(&file.entry.path)).collect(),
    });
    outcome.notes.push(Note::NotYet { path: path.clone(), application });
    outcome.roots.push(RootSummary { path, application, bases: Vec::new(), checked: false });
}

/// A path, or what stands for the working directory.
pub(in crate::engine) fn shown(path: &str) -> &str {
    if path.is_empty() { "." } else { path }
}
