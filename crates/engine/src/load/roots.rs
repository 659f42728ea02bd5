//! Data roots: where they are in the inputs, and which of them are checked.

use std::collections::{BTreeMap, BTreeSet};

use super::super::error::{Error, PathFault};
use super::super::settle::Scope;
use super::copy::{Certain, certain, faults, is_copy, meant};
use super::found::{leave_to_homes, roots_beside, roots_of};
use super::identify::is_pack;
use super::input::Input;
use super::loose::{Given, Outside, Seen};
use super::pack::{asked, packed};
use super::place::Place;
use super::set_aside::set_aside;
use super::singly::unpacked_singly;
use super::taken::Taken;
use mhlint_config::Config;
use mhlint_diag::{Application, Identity, NotChecked, Note, Outcome, RootSummary, Unchecked};
use mhlint_discover::{Layout, Meant, Role, candidates, is_asset_anywhere, is_of_macos};
use mhlint_source::{EntryKind, Tree, WalkFaultKind, folders_above, is_below};

/// What a run reads.
pub(crate) struct Roots<'t> {
    /// What to check, with the parts that alone are asked for.
    pub(crate) checked: Vec<(Place<'t>, Vec<String>)>,
    /// `--system`: one data root an application, unless it is all there is to check.
    pub(crate) systems: Vec<Place<'t>>,
}

/// Those of the applications of which one of the places has data.
pub(super) fn with_data(applications: &[Application], places: &[Place<'_>]) -> Vec<Application> {
    applications
        .iter()
        .copied()
        .filter(|one| places.iter().any(|place| place.is_of(*one)))
        .collect()
}

/// The data roots in a tree of the applications that are checked; `asked` are those asked for by
/// name, or by their data.
pub(super) fn checked_places<'t>(
    tree: &'t Tree,
    asked: &[Application],
    applications: &[Application],
) -> Vec<Place<'t>> {
    places(
        tree,
        roots_of(tree, asked, |application| {
            applications.contains(&application)
        }),
    )
}

fn places(
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

/// The data roots inside another one that are of other applications; inside a pack those of its own
/// as well, since what is parked there is no part of it.
fn inner(
    tree: &Tree,
    roots: &BTreeMap<String, Vec<&'static Layout>>,
    path: &str,
    layouts: &[&'static Layout],
) -> Vec<String> {
    let is_of = |own: &[&'static Layout], other: &Layout| {
        own.iter().any(|one| one.application == other.application)
    };
    let is_foreign = |others: &[&'static Layout]| !others.iter().any(|other| is_of(layouts, other));
    let inside: Vec<_> = roots
        .iter()
        .filter(|(other, _)| other.as_str() != path && is_below(other, path))
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
            [vec![other.clone()], beside_root(tree, other, layouts)].concat()
        })
        .collect()
}

/// The files that belong to a data root beside it.
pub(super) fn beside_root(tree: &Tree, root: &str, layouts: &[&'static Layout]) -> Vec<String> {
    let own = layouts.iter().filter(|layout| !layout.beside.is_empty());
    let files = own.flat_map(|layout| candidates(tree, root, &[layout]));
    files
        .filter(|file| file.is_loose)
        .map(|file| file.entry.path.clone())
        .collect()
}

/// The places in packs, each with the applications that may be meant by what is in it.
fn in_packs<'t>(
    packs: &[(&'t Input, Certain)],
    systems: &[Place<'t>],
    options: &Config,
    applications: &[Application],
) -> Result<Vec<(Place<'t>, Vec<String>)>, Error> {
    let given = Given::of(systems, options);
    let bases_of = |application| {
        let own = systems
            .iter()
            .filter(move |system| system.is_of(application));
        own.flat_map(base_meshes).collect()
    };
    let all = asked(applications, systems, options).into_iter();
    let all: Vec<_> = all.map(|one| (one, bases_of(one))).collect();
    let mut found = Vec::new();
    for (pack, certain) in packs {
        let of_pack = meant(certain, &all, options);
        let places = packed(pack, &of_pack, options)?;
        let is_left = |one: &Application| !places.iter().any(|place| place.is_of(*one));
        let rest = of_pack.iter().filter(|(one, _)| is_left(one));
        found.extend(unpacked_singly(pack, rest, systems, &given)?);
        found.extend(places.into_iter().map(|place| (place, Vec::new())));
    }
    Ok(found)
}

/// The layouts of all roots of an input, each once.
fn layouts_of(
    roots: &BTreeMap<String, Vec<&'static Layout>>,
    applications: &[Application],
) -> Vec<&'static Layout> {
    let all = roots.values().flatten();
    let all: BTreeMap<_, _> = all.map(|one| (one.application, *one)).collect();
    let is_checked = |one: &&Layout| applications.contains(&one.application);
    all.into_values().filter(is_checked).collect()
}

/// The data root of all inputs, where there is one.
fn the_only_root(found: &[Found<'_>]) -> Option<String> {
    let shown = |(input, roots): &Found<'_>| -> Vec<String> {
        roots.keys().map(|root| input.tree.shown(root)).collect()
    };
    let mut all = found.iter().flat_map(shown);
    all.next().filter(|first| all.all(|other| other == *first))
}

impl<'t> Roots<'t> {
    /// Looks for them: data roots, and files outside of any.
    pub(crate) fn of(
        inputs: &'t [Input],
        systems: &'t [Tree],
        scope: &Scope<'_>,
        options: &Config,
        applications: &[Application],
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
        let mut systems = all_systems(systems, applications)?;
        // What shares its users' folders with another application has them where its data are
        // given.
        let mut at_hand = options.applications.clone();
        if at_hand.is_empty() {
            at_hand = with_data(applications, &systems);
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
            applications,
        };
        let found = taken.all(found);
        let given = Given::of(&systems, options);
        let mut packed_places = in_packs(&packs, &systems, options, applications)?;
        let asked: Vec<Application> = applications
            .iter()
            .copied()
            .filter(|application| options.asks_for(*application))
            .collect();
        for (input, roots) in &found {
            let layouts = layouts_of(roots, applications);
            packed_places.extend(faults(input, &layouts).map(|place| (place, Vec::new())));
        }
        // What belongs to data roots, and what is no asset.
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
        let mut roots = Self {
            checked: Vec::new(),
            systems,
        };
        for (input, all, (path, layouts)) in found
            .iter()
            .flat_map(|(input, roots)| roots.iter().map(move |one| (*input, roots, one)))
        {
            let shown = input.tree.shown(path);
            if !scope.excludes(&shown) && !below.contains(&shown) {
                let asked = layouts
                    .iter()
                    .copied()
                    .filter(|layout| options.asks_for(layout.application));
                let (checked, others) =
                    asked.partition(|layout| applications.contains(&layout.application));
                let inner = inner(&input.tree, all, path, layouts);
                roots.add(input, path, inner, [checked, others], outcome);
            }
        }
        for (place, narrow) in outside {
            roots.want(place, &narrow);
        }
        // Of one zip there may be several places, each with files of its own.
        roots.checked.extend(packed_places);
        Ok(roots)
    }

    /// A data root with the layouts that are asked for: of applications that are checked, and of
    /// others.
    fn add(
        &mut self,
        input: &'t Input,
        path: &str,
        inner: Vec<String>,
        [checked, others]: [Vec<&'static Layout>; 2],
        outcome: &mut Outcome,
    ) {
        if !checked.is_empty() {
            self.want(
                Place::around(&input.tree, path, &checked, inner),
                &input.narrow,
            );
        }
        for layout in others {
            note_unchecked(&Place::new(&input.tree, path, &[layout]), layout, outcome);
        }
    }

    /// A root that two PATHs lead to is checked once, for everything that either asks for.
    fn want(&mut self, place: Place<'t>, narrow: &[String]) {
        match self
            .checked
            .iter_mut()
            .find(|(known, _)| known.is_counterpart(&place))
        {
            Some((_, known)) if known.is_empty() || narrow.is_empty() => known.clear(),
            Some((_, known)) => known.extend_from_slice(narrow),
            None => self.checked.push((place, narrow.to_vec())),
        }
    }
}

/// The data roots of each input. What shares its users' folders has those of one input where its
/// data are in another.
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

/// The data roots of all of `--system`. Which of two of one application counts nobody can tell.
fn all_systems<'t>(
    trees: &'t [Tree],
    applications: &[Application],
) -> Result<Vec<Place<'t>>, Error> {
    let mut all: Vec<Place<'t>> = Vec::new();
    for tree in trees {
        for place in system_places(tree, applications)? {
            let is_twice = |one: &&Application| {
                place.is_of(**one) && all.iter().any(|other| other.is_of(**one))
            };
            let first =
                |one: Application| all.iter().find(|other| other.is_of(one)).map(Place::path);
            match applications
                .iter()
                .find(is_twice)
                .and_then(|one| Some((*one, first(*one)?)))
            {
                // The same folder, or one below the other.
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

/// The data roots of `--system`: the first of each application.
pub(super) fn system_places<'t>(
    tree: &'t Tree,
    applications: &[Application],
) -> Result<Vec<Place<'t>>, Error> {
    let is_system = |path: &str, layout: &'static Layout| {
        layout.shares_roots_of.is_none()
            || (layout.role)(&candidates(tree, path, &[layout])) != Role::User
    };
    let roots = roots_of(tree, &[], |application| applications.contains(&application)).into_iter();
    // What MPFB shares with others is a user's: its own data are not.
    let roots = roots.map(|(path, mut layouts)| {
        layouts.retain(|layout| is_system(&path, layout));
        (path, layouts)
    });
    let mut places = places(tree, roots.filter(|(_, layouts)| !layouts.is_empty()));
    let mut missing = applications.to_vec();
    places.retain(|place| {
        let wanted = missing.len();
        missing.retain(|application| !place.is_of(*application));
        missing.len() < wanted
    });
    let nothing = || PathFault::NoDataOf(applications.to_vec());
    if places.is_empty() {
        Err(Error::Path {
            path: tree.label().to_owned(),
            fault: nothing(),
        })
    } else {
        Ok(places)
    }
}

/// The data roots in an input, by path.
pub(super) type Found<'i> = (&'i Input, BTreeMap<String, Vec<&'static Layout>>);

/// The files outside of data roots as each application would have them, with the parts that alone
/// are asked for. Where none is asked for by name, those come first whose data are at hand, and the
/// others have what is left.
fn places_outside<'t>(
    found: &[Found<'t>],
    beside: &[BTreeSet<String>],
    systems: &[Place<'_>],
    asked: &[Application],
    given: &Given<'_>,
) -> Result<Vec<(Place<'t>, Vec<String>)>, Error> {
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

/// The files beside data roots that belong to these.
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

/// Says what outside of data roots is not checked: folders that could not be listed, and assets of
/// other kinds than those that are checked alone.
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
        // Around a file that alone was named more is listed than anybody asks for.
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

fn note_unchecked(place: &Place<'_>, layout: &Layout, outcome: &mut Outcome) {
    let (root, application) = (place.path(), layout.application);
    let path = shown(&root).to_owned();
    let files = place.below.iter().filter(|file| file.is_file());
    let files = files
        .map(|file| place.tree.shown(&file.entry.path))
        .collect();
    outcome.not_checked.push(NotChecked::of(
        Some(application),
        Unchecked::Application,
        files,
    ));
    outcome.roots.push(RootSummary {
        path,
        application,
        bases: Vec::new(),
        identity: Identity::default(),
        checked: false,
    });
}

/// A path, or what stands for the working directory.
pub(crate) fn shown(path: &str) -> &str {
    if path.is_empty() { "." } else { path }
}
