//! Data roots: where they are in the inputs, and which of them are checked.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;
use std::sync::Arc;

use super::super::error::{Error, PathFault};
use super::super::settle::Scope;
use super::copy::{Certain, certain, faults, is_copy, meant};
use super::found::{leave_to_homes, roots_beside, roots_of};
use super::identify::is_pack;
use super::input::Input;
use super::loose::{Given, Outside, Seen};
use super::narrow::Narrow;
use super::pack::{asked, packed};
use super::place::{Place, PlaceKey};
use super::set_aside::set_aside;
use super::singly::unpacked_singly;
use super::taken::Taken;
use mhlint_config::Config;
use mhlint_diag::{Application, NotChecked, Note, Outcome, Unchecked};
use mhlint_discover::{Layout, Meant, Role, candidates, is_asset_anywhere, is_of_macos};
use mhlint_source::{EntryKind, Tree, WalkFaultKind, folders_above};

/// What a run reads.
pub(crate) struct Roots<'t> {
    /// The places to check, each with what of it the user asked for.
    pub(crate) checked: Vec<(Place<'t>, Arc<Narrow>)>,
    /// The data roots from `--system`, at most one for each application. A data root that is also
    /// the only one to check is left out here.
    pub(crate) systems: Vec<Place<'t>>,
}

/// The applications that have data in at least one of the places.
pub(super) fn with_data(places: &[Place<'_>]) -> Vec<Application> {
    Application::ALL
        .into_iter()
        .filter(|one| places.iter().any(|place| place.is_of(*one)))
        .collect()
}

/// The data roots of a tree with what is in them.
pub(super) fn places(
    tree: &Tree,
    roots: impl IntoIterator<Item = (String, Vec<&'static Layout>)>,
) -> Vec<Place<'_>> {
    let roots: BTreeMap<String, Vec<&'static Layout>> = roots.into_iter().collect();
    let inner = |path: &str, layouts: &[&'static Layout]| inner(tree, &roots, path, layouts);
    roots
        .iter()
        .map(|(path, layouts)| Place::around(tree, path, layouts, inner(path, layouts)))
        .collect()
}

/// The data roots inside the data root at `path` that are not part of it: those of other
/// applications. Inside a pack data roots of the same application are not part of it either, since
/// they were only put there.
fn inner(
    tree: &Tree,
    roots: &BTreeMap<String, Vec<&'static Layout>>,
    path: &str,
    layouts: &[&'static Layout],
) -> BTreeSet<String> {
    let is_of = |own: &[&'static Layout], other: &Layout| {
        own.iter().any(|one| one.application == other.application)
    };
    let is_foreign = |others: &[&'static Layout]| !others.iter().any(|other| is_of(layouts, other));
    let start = if path.is_empty() {
        String::new()
    } else {
        format!("{path}/")
    };
    let from = roots.range::<str, _>((Bound::Included(start.as_str()), Bound::Unbounded));
    let inside: Vec<_> = from
        .take_while(|(other, _)| other.starts_with(&start))
        .filter(|(other, _)| other.as_str() != path)
        .collect();
    let is_pack = !inside.is_empty()
        && layouts
            .iter()
            .all(|layout| is_pack(&candidates(tree, path, &[layout]), layout));
    let inside = inside
        .into_iter()
        .filter(|(_, others)| is_pack || is_foreign(others));
    inside
        .flat_map(|(other, layouts)| {
            let beside = beside_root(tree, other, layouts);
            std::iter::once(other.clone()).chain(beside)
        })
        .collect()
}

/// The files that lie beside a data root and belong to it.
pub(super) fn beside_root(tree: &Tree, root: &str, layouts: &[&'static Layout]) -> Vec<String> {
    let own = layouts.iter().filter(|layout| !layout.beside.is_empty());
    let files = own.flat_map(|layout| candidates(tree, root, &[layout]));
    files
        .filter(|file| file.is_loose)
        .map(|file| file.entry.path.clone())
        .collect()
}

/// The places to check in the packs among the inputs, one for each application that the pack may be
/// for.
fn in_packs<'t>(
    packs: &[(&'t Input, Certain)],
    systems: &[Place<'t>],
    options: &Config,
) -> Result<Vec<(Place<'t>, Arc<Narrow>)>, Error> {
    let given = Given::of(systems, options);
    let bases_of = |application| {
        let own = systems
            .iter()
            .filter(move |system| system.is_of(application));
        own.flat_map(base_meshes).collect()
    };
    let all = asked(systems, options).into_iter();
    let all: Vec<_> = all.map(|one| (one, bases_of(one))).collect();
    let mut found = Vec::new();
    for (pack, certain) in packs {
        let of_pack = meant(certain, &all, options);
        let places = packed(pack, &of_pack, options)?;
        let is_left = |one: &Application| !places.iter().any(|place| place.is_of(*one));
        let rest = of_pack.iter().filter(|(one, _)| is_left(one));
        found.extend(unpacked_singly(pack, rest, systems, &given)?);
        found.extend(places.into_iter().map(|place| (place, Arc::default())));
    }
    Ok(found)
}

/// The layouts of all data roots of an input, each once.
fn layouts_of(roots: &BTreeMap<String, Vec<&'static Layout>>) -> Vec<&'static Layout> {
    let all = roots.values().flatten();
    let all: BTreeMap<_, _> = all.map(|one| (one.application, *one)).collect();
    all.into_values().collect()
}

/// The path of the only data root in all inputs; `None` if there are none or several.
fn the_only_root(found: &[Found<'_>]) -> Option<String> {
    let shown = |(input, roots): &Found<'_>| -> Vec<String> {
        roots.keys().map(|root| input.tree.shown(root)).collect()
    };
    let mut all = found.iter().flat_map(shown);
    all.next().filter(|first| all.all(|other| other == *first))
}

impl<'t> Roots<'t> {
    /// Finds what to check in the inputs: data roots, packs, and files that lie in no data root.
    pub(crate) fn of(
        inputs: &'t [Input],
        systems: &'t [Tree],
        scope: &Scope<'_>,
        options: &Config,
        outcome: &mut Outcome,
    ) -> Result<Self, Error> {
        let (mut packs, mut folders) = (Vec::new(), Vec::new());
        for input in inputs {
            let certain = input.tree.pack().map(|_| certain(input, options));
            match certain.filter(|certain| !is_copy(input, certain, options)) {
                Some(certain) => packs.push((input, certain)),
                None => folders.push(input),
            }
        }
        let mut systems = all_systems(systems)?;
        // MPFB shares the users' folders of MakeHuman 1. If the user names no application, such a
        // folder is taken for one of MPFB only if data of MPFB are given.
        let mut at_hand = options.applications.clone();
        if at_hand.is_empty() {
            at_hand = with_data(&systems);
        }
        let bases: BTreeSet<String> = systems
            .iter()
            .flat_map(base_meshes)
            .chain(options.bases.iter().cloned())
            .collect();
        let mut found = found_in(
            &folders,
            Meant {
                asked: &at_hand,
                named: &options.applications,
                at_hand: &[],
            },
            &bases,
        );
        let left = set_aside(&mut found, outcome);
        let taken = Taken {
            systems: &systems,
            options,
        };
        let found = taken.all(found);
        let given = Given::of(&systems, options);
        let mut packed_places = in_packs(&packs, &systems, options)?;
        let asked: Vec<Application> = Application::ALL
            .into_iter()
            .filter(|application| options.asks_for(*application))
            .collect();
        for (input, roots) in &found {
            let layouts = layouts_of(roots);
            packed_places.extend(faults(input, &layouts).map(|place| (place, Arc::default())));
        }
        // The files that lie outside of data roots and are no loose assets: those that belong to a
        // data root beside them, and those that were set aside.
        let mut beside: Vec<BTreeSet<String>> = found
            .iter()
            .map(|(input, roots)| beside(input, roots))
            .collect();
        beside
            .iter_mut()
            .zip(left)
            .for_each(|(beside, left)| beside.extend(left));
        let outside = places_outside(&found, &beside, &systems, &asked, &given)?;
        note_outside(
            &found,
            &beside,
            outside.iter().map(|(place, _)| place),
            outcome,
        );
        let all_given = the_only_root(&found);
        for all in systems.extract_if(.., |system| all_given == Some(system.path())) {
            outcome.notes.push(Note::SystemIsChecked {
                path: shown(&all.path()).to_owned(),
            });
        }
        let below: Vec<String> = systems.iter().map(Place::path).collect();
        let mut wanted = Wanted::default();
        for (input, all, (path, layouts)) in found
            .iter()
            .flat_map(|(input, roots)| roots.iter().map(move |one| (*input, roots, one)))
        {
            let shown = input.tree.shown(path);
            if !scope.excludes(&shown) && !below.contains(&shown) {
                let asked: Vec<_> = layouts
                    .iter()
                    .copied()
                    .filter(|layout| options.asks_for(layout.application))
                    .collect();
                if !asked.is_empty() {
                    let inner = inner(&input.tree, all, path, layouts);
                    let place = Place::around(&input.tree, path, &asked, inner);
                    wanted.want(place, Arc::clone(&input.narrow));
                }
            }
        }
        for (place, narrow) in outside {
            wanted.want(place, narrow);
        }
        let mut checked = wanted.places;
        // Added without `want`, which would join places: one zip may give several places for one
        // path, each with other files.
        checked.extend(packed_places);
        Ok(Self { checked, systems })
    }
}

/// The places to check, as they are found.
#[derive(Default)]
struct Wanted<'t> {
    places: Vec<(Place<'t>, Arc<Narrow>)>,
    /// Numbers of these.
    known: BTreeMap<PlaceKey, usize>,
}

impl<'t> Wanted<'t> {
    /// Adds a place to check. If two PATHs lead to the same place it is checked once, for
    /// everything that either PATH asks for.
    fn want(&mut self, place: Place<'t>, narrow: Arc<Narrow>) {
        let number = *self.known.entry(place.key()).or_insert(self.places.len());
        match self.places.get_mut(number) {
            Some((_, known)) => Arc::make_mut(known).join(&narrow),
            None => self.places.push((place, narrow)),
        }
    }
}

/// The data roots of each input. MPFB shares the users' folders of MakeHuman 1: if data of MPFB are
/// in one input, such folders are looked for again in all inputs, now as folders of MPFB, too.
fn found_in<'i>(
    inputs: &[&'i Input],
    meant: Meant<'_>,
    bases: &BTreeSet<String>,
) -> Vec<Found<'i>> {
    let of = |input: &&'i Input, at_hand: &[Application]| {
        (
            *input,
            roots_beside(&input.tree, Meant { at_hand, ..meant }, bases, |_| true),
        )
    };
    let mut found: Vec<Found<'_>> = inputs.iter().map(|input| of(input, &[])).collect();
    let is_data = |input: &Input, path: &str, layout: &&'static Layout| {
        layout.shares_roots_of.is_some()
            && (layout.role)(&candidates(&input.tree, path, &[layout])) != Role::User
    };
    let mut at_hand: Vec<Application> = Vec::new();
    for (input, roots) in found.iter().filter(|_| inputs.len() > 1) {
        let layouts = roots
            .iter()
            .flat_map(|(path, layouts)| layouts.iter().map(move |layout| (path, *layout)));
        at_hand.extend(
            layouts
                .filter(|(path, layout)| is_data(input, path, layout))
                .map(|(_, one)| one.application),
        );
    }
    if !at_hand.is_empty() {
        found = inputs.iter().map(|input| of(input, &at_hand)).collect();
    }
    leave_to_homes(&mut found, meant.named);
    found
}

/// The data roots of all `--system` folders. Two different ones for one application are an error,
/// because nobody can tell which of them is meant.
fn all_systems(trees: &[Tree]) -> Result<Vec<Place<'_>>, Error> {
    let mut all: Vec<Place<'_>> = Vec::new();
    for tree in trees {
        for place in system_places(tree)? {
            let is_twice = |one: &&Application| {
                place.is_of(**one) && all.iter().any(|other| other.is_of(**one))
            };
            let first =
                |one: Application| all.iter().find(|other| other.is_of(one)).map(Place::path);
            match Application::ALL
                .iter()
                .find(is_twice)
                .and_then(|one| Some((*one, first(*one)?)))
            {
                // The same folder again, or a folder around it or in it: both lead to one data
                // root.
                Some((_, first)) if first == place.path() => {}
                Some((application, first)) => {
                    return Err(Error::Path {
                        path: place.path(),
                        fault: PathFault::SecondSystem { application, first },
                    });
                }
                None => all.push(place),
            }
        }
    }
    Ok(all)
}

/// The data roots in one `--system` folder: for each application the first.
pub(super) fn system_places(tree: &Tree) -> Result<Vec<Place<'_>>, Error> {
    let is_system = |path: &str, layout: &'static Layout| {
        layout.shares_roots_of.is_none()
            || (layout.role)(&candidates(tree, path, &[layout])) != Role::User
    };
    let roots = roots_of(tree, &[], |_| true).into_iter();
    // A folder that MPFB shares with MakeHuman 1 is a user's folder and cannot be system data; the
    // data of MPFB itself can.
    let roots = roots.map(|(path, mut layouts)| {
        layouts.retain(|layout| is_system(&path, layout));
        (path, layouts)
    });
    let mut places = places(tree, roots.filter(|(_, layouts)| !layouts.is_empty()));
    let mut missing = Application::ALL.to_vec();
    places.retain(|place| {
        let wanted = missing.len();
        missing.retain(|application| !place.is_of(*application));
        missing.len() < wanted
    });
    if places.is_empty() {
        Err(Error::Path {
            path: tree.label().to_owned(),
            fault: PathFault::NoData,
        })
    } else {
        Ok(places)
    }
}

/// An input with its data roots: for each path the layouts of the applications whose root it is.
pub(super) type Found<'i> = (&'i Input, BTreeMap<String, Vec<&'static Layout>>);

/// The files outside of data roots, at the places where each application would have them, and for
/// each place the paths in it that the user asked for. If the user names no application, the
/// applications with data in this run choose first, and the others get the files that are left.
fn places_outside<'t>(
    found: &[Found<'t>],
    beside: &[BTreeSet<String>],
    systems: &[Place<'_>],
    asked: &[Application],
    given: &Given<'_>,
) -> Result<Vec<(Place<'t>, Arc<Narrow>)>, Error> {
    let options = given.options;
    let is_there = |application: &Application| {
        let layouts = || found.iter().flat_map(|(_, roots)| roots.values()).flatten();
        let is_found = || layouts().any(|layout| layout.application == *application);
        if systems.is_empty() {
            is_found()
        } else {
            systems.iter().any(|system| system.is_of(*application))
        }
    };
    let is_first =
        |application: &Application| !options.applications.is_empty() || is_there(application);
    let (first, others): (Vec<Application>, Vec<Application>) =
        asked.iter().partition(|one| is_first(one));
    let mut places = Vec::new();
    for ((input, roots), beside) in found.iter().zip(beside) {
        let mut taken = beside.clone();
        for (applications, is_meant) in [(&first, true), (&others, false)] {
            let before = taken.clone();
            for application in applications
                .iter()
                .filter(|one| input.tests.is_none_or(|tests| tests == **one))
            {
                let own = systems.iter().filter(|system| system.is_of(*application));
                let bases = own.flat_map(base_meshes).collect();
                let is_meant = is_meant || input.tests.is_some();
                let outside = Outside {
                    input,
                    roots,
                    taken: &before,
                    bases: &bases,
                    is_meant,
                    given,
                    seen: Seen::default(),
                };
                let place = outside.place(Layout::of(*application))?;
                taken.extend(
                    place
                        .iter()
                        .flat_map(|(place, _)| &place.below)
                        .map(|file| file.entry.path.clone()),
                );
                places.extend(place);
            }
        }
    }
    Ok(places)
}

/// The files that lie beside the data roots of an input and belong to them.
fn beside(input: &Input, roots: &BTreeMap<String, Vec<&'static Layout>>) -> BTreeSet<String> {
    roots
        .iter()
        .flat_map(|(root, layouts)| beside_root(&input.tree, root, layouts))
        .collect()
}

fn base_meshes(place: &Place<'_>) -> BTreeSet<String> {
    let meshes = place.files().filter(|file| file.kind().is_base_mesh());
    meshes
        .filter_map(|file| file.owner().map(str::to_owned))
        .collect()
}

/// Notes what outside of data roots is not checked: folders that could not be listed, and assets
/// that are not checked without a data root.
fn note_outside<'p, 't: 'p>(
    found: &[(&Input, BTreeMap<String, Vec<&'static Layout>>)],
    beside: &[BTreeSet<String>],
    checked: impl Iterator<Item = &'p Place<'t>>,
    outcome: &mut Outcome,
) {
    let (mut closed, mut others) = (BTreeSet::new(), BTreeSet::new());
    for ((input, roots), beside) in found.iter().zip(beside) {
        let is_outside = |path: &str| {
            !beside.contains(path) && !folders_above(path).any(|one| roots.contains_key(one))
        };
        let faults = input
            .tree
            .faults()
            .iter()
            .filter(|fault| matches!(fault.kind, WalkFaultKind::Unreadable { .. }));
        let shut = faults
            .filter(|fault| is_outside(&fault.path))
            .map(|fault| input.tree.shown(&fault.path));
        // If the user names a single file its whole folder is listed; faults beside the file are of
        // no interest then.
        closed.extend(shut.filter(|path| !input.is_beside || input.asks_for(path)));
        let files = input
            .tree
            .entries()
            .iter()
            .filter(|entry| entry.kind == EntryKind::File && is_outside(&entry.path));
        let files = files.filter(|entry| !is_of_macos(&entry.path));
        let shown = files.map(|entry| (entry, input.tree.shown(&entry.path)));
        let assets = shown
            .filter(|(entry, shown)| input.named.contains(shown) || is_asset_anywhere(&entry.path));
        others.extend(
            assets
                .map(|(_, shown)| shown)
                .filter(|shown| input.asks_for(shown)),
        );
    }
    for place in checked {
        for file in &place.below {
            others.remove(&place.tree.shown(&file.entry.path));
        }
    }
    for (what, paths) in [(Unchecked::Closed, closed), (Unchecked::Outside, others)] {
        if !paths.is_empty() {
            outcome.not_checked.push(NotChecked::of(None, what, paths));
        }
    }
}

/// A path as it is printed: `.` for the working directory, whose path is empty.
pub(crate) fn shown(path: &str) -> &str {
    if path.is_empty() { "." } else { path }
}
