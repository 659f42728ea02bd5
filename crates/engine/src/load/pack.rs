//! A zip as what it becomes: a user's data folder, once an importer has put its files there or it
//! is unpacked into it.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::super::error::Error;
use super::input::Input;
use super::place::Place;
use mhlint_config::Config;
use mhlint_diag::Application;
use mhlint_discover::{Candidate, Kind, Layout, Listing, Meant, Refusal, find_roots, loss};
use mhlint_repo::{Import, Names, Pack};
use mhlint_source::{Entry, EntryKind, MemberFault, PackFacts, Tree, inside};

/// Where an importer puts a path of a pack, for a base mesh.
type Importer = fn(&str, &str) -> Option<String>;

/// The applications that the files of a pack are checked for: those that are asked for, else those
/// of the system data.
pub(super) fn asked(systems: &[Place<'_>], options: &Config) -> Vec<Application> {
    let is_given =
        |application: &Application| systems.iter().any(|system| system.is_of(*application));
    let by_system = options.applications.is_empty() && !systems.is_empty();
    let is_asked = |one: &Application| options.asks_for(*one) && (!by_system || is_given(one));
    Application::ALL.into_iter().filter(is_asked).collect()
}

/// What a pack is to each of these applications, with the base meshes of its system data.
pub(super) fn packed<'t>(
    input: &'t Input,
    applications: &[(Application, BTreeSet<String>)],
    options: &Config,
) -> Result<Vec<Place<'t>>, Error> {
    let Some(facts) = input.tree.pack() else {
        return Ok(Vec::new());
    };
    // Who asks for applications gets them; else the pack may say whose it is.
    let may_choose = options.applications.is_empty() && applications.len() > 1;
    let of_applications = applications
        .iter()
        .map(|(application, bases)| (Layout::of(*application), bases));
    let (layouts, bases): (Vec<&'static Layout>, Vec<_>) = of_applications
        .filter(|(layout, _)| !may_choose || is_for(&input.tree, layout, facts))
        .unzip();
    let mut places = Vec::new();
    for (layout, bases) in layouts.iter().zip(bases) {
        places.extend(match layout.import {
            Some(import) if !(may_choose && is_data_of_another(&input.tree, layout, import)) => {
                let base = base(input, bases, options)?;
                imported(&input.tree, facts, layout, import, base, options)
            }
            // Only an importer adds base meshes.
            None if !(may_choose && input.new_base.is_some()) => {
                unpacked(&input.tree, layout, facts)
            }
            _ => None,
        });
    }
    if facts.fault.is_none() && facts.faults.is_empty() {
        return Ok(places);
    }
    // What is wrong with the zip is one matter for all of them.
    let pack = || Pack {
        faults: Some(Arc::clone(facts)),
        ..Pack::default()
    };
    match places.as_mut_slice() {
        [only] if layouts.len() == 1 => {
            only.pack.get_or_insert_default().faults = Some(Arc::clone(facts));
        }
        _ => places.push(Place::of_pack(
            &input.tree,
            "",
            &layouts,
            Vec::new(),
            pack(),
        )),
    }
    Ok(places)
}

/// The files of a pack where an importer puts them.
fn imported<'t>(
    tree: &'t Tree,
    facts: &PackFacts,
    layout: &'static Layout,
    import: Importer,
    base: String,
    options: &Config,
) -> Option<Place<'t>> {
    let mut found: BTreeMap<String, Vec<&Entry>> = BTreeMap::new();
    let mut places = BTreeMap::new();
    for entry in files(tree) {
        let read_as = facts.unmarked.get(&entry.path).unwrap_or(&entry.path);
        let place = import(read_as, &base);
        place
            .iter()
            .for_each(|place| found.entry(place.clone()).or_default().push(entry));
        places.insert(entry.path.clone(), place);
    }
    let overwritten = found
        .iter()
        .filter(|(_, entries)| !are_equal(tree, entries, options));
    let overwritten = overwritten
        .map(|(place, entries)| (place.clone(), paths(entries)))
        .collect();
    let below = found
        .into_iter()
        .filter_map(|(place, entries)| Some((place, *entries.last()?)));
    let below: Vec<_> = below
        .map(|(place, entry)| Candidate::imported(entry, place, layout))
        .collect();
    let lost =
        |path: &String| loss(path).is_some() && places.get(path).is_some_and(Option::is_none);
    if !below.iter().any(|one| one.kind() != Kind::Other) && !places.keys().any(lost) {
        return None;
    }
    let import = Some(Import {
        base,
        places,
        overwritten,
    });
    let pack = Pack {
        import,
        lost: lost_below("", facts),
        names: names_below("", facts),
        ..Pack::default()
    };
    Some(Place::of_pack(tree, "", &[layout], below, pack))
}

/// The names of a pack that its importer takes otherwise than they were meant, of what lies below a
/// folder.
fn names_below(root: &str, facts: &PackFacts) -> Names {
    let below = |path: &String| inside(path, root).map(str::to_owned);
    let of_kind = |wanted: fn(&MemberFault) -> bool| {
        let faults = facts.faults.iter().filter(move |(_, fault)| wanted(fault));
        faults.filter_map(|(name, _)| below(name)).collect()
    };
    Names {
        misread: facts
            .unmarked
            .iter()
            .filter_map(|(path, read_as)| Some((below(path)?, read_as.clone())))
            .collect(),
        backslashes: facts.backslashes.iter().filter_map(below).collect(),
        links: of_kind(|fault| matches!(fault, MemberFault::Link { .. })),
        replaced: of_kind(|fault| *fault == MemberFault::Replaced),
    }
}

fn files(tree: &Tree) -> impl Iterator<Item = &Entry> {
    tree.entries()
        .iter()
        .filter(|entry| entry.kind == EntryKind::File)
}

fn paths(entries: &[&Entry]) -> BTreeSet<String> {
    entries.iter().map(|entry| entry.path.clone()).collect()
}

/// Whether it makes no difference which of the files is kept.
fn are_equal(tree: &Tree, entries: &[&Entry], options: &Config) -> bool {
    let read = |entry: &Entry| tree.read(entry, &options.limits).ok();
    match entries {
        [] | [_] => true,
        [first, others @ ..] => {
            let is_equal = |other: &&Entry| other.size == first.size && read(other) == read(first);
            others.iter().all(is_equal)
        }
    }
}

/// The base mesh that a pack is imported for: the one in its name, the one that is asked for, the
/// only one there is.
fn base(input: &Input, bases: &BTreeSet<String>, options: &Config) -> Result<String, Error> {
    let only = || {
        bases
            .first()
            .filter(|_| bases.len() == 1)
            .map_or(Layout::USUAL_BASE, String::as_str)
    };
    match (&input.new_base, options.bases.as_slice()) {
        (Some(new), _) => Ok(new.clone()),
        (None, []) => Ok(only().to_owned()),
        (None, [asked]) => Ok(asked.clone()),
        (None, _) => Err(Error::SeveralBases {
            file: input.tree.label().to_owned(),
        }),
    }
}

/// Whether an importer takes nothing of a pack because it is the data folder of an application
/// without one, or what is in it.
fn is_data_of_another(tree: &Tree, layout: &Layout, import: Importer) -> bool {
    let others = Application::ALL
        .map(Layout::of)
        .into_iter()
        .filter(|other| other.import.is_none());
    let mut roots = others.filter_map(|other| root_in(tree, other));
    let is_anothers = roots.any(|root| root.is_empty() || root == "data");
    let is_imported = files(tree).any(|entry| import(&entry.path, Layout::USUAL_BASE).is_some());
    let own = find_roots(
        &Listing::of(files(tree).map(|entry| entry.path.as_str()), []),
        Meant::default(),
    );
    is_anothers
        && !is_imported
        && !own
            .iter()
            .any(|root| root.application == layout.application)
}

/// Whether a pack is one of an application that nobody asks for by name. One that shares its users'
/// folders with another has those that its importer takes.
fn is_for(tree: &Tree, layout: &Layout, facts: &PackFacts) -> bool {
    let Some(refuses) = layout.refuses else {
        return true;
    };
    let is_listed =
        |path: &str| layout.is_asset(path) && layout.use_of(path).kind != Kind::PackMetadata;
    let mut paths = files(tree).map(|entry| entry.path.as_str());
    facts.fault.is_none() && refuses(&facts.names).is_none() && paths.any(is_listed)
}

/// Why the importer refuses a pack. One that is damaged as a whole has a finding for that.
fn refusal(layout: &Layout, facts: &PackFacts) -> Option<Refusal> {
    layout.refuses.filter(|_| facts.fault.is_none())?(&facts.names)
}

/// The files of a pack where they lie once it is unpacked: into the data folder, or around it.
fn unpacked<'t>(tree: &'t Tree, layout: &'static Layout, facts: &PackFacts) -> Option<Place<'t>> {
    let refusal = refusal(layout, facts);
    // Of what is refused there is something to say, whatever is in it.
    let root = root_in(tree, layout).or_else(|| refusal.as_ref().map(|_| String::new()))?;
    let names = if layout.refuses.is_some() {
        names_below(&root, facts)
    } else {
        Names::default()
    };
    let pack = Pack {
        lost: lost_below(&root, facts),
        refusal,
        names,
        ..Pack::default()
    };
    let mut place = Place::new(tree, &root, &[layout]);
    place.pack = Some(pack);
    Some(place)
}

/// The members that are no files, by path below a folder.
fn lost_below(root: &str, facts: &PackFacts) -> BTreeSet<String> {
    facts
        .faults
        .iter()
        .filter_map(|(path, _)| inside(path, root))
        .map(str::to_owned)
        .collect()
}

/// The folder of a pack with the folders of a data root in it: the first, and none below another.
fn root_in(tree: &Tree, layout: &Layout) -> Option<String> {
    let root = |entry: &Entry| {
        let parts: Vec<&str> = entry.path.split('/').collect();
        let (_, folders) = parts.split_last()?;
        let at = folders
            .iter()
            .position(|folder| layout.has_at_top(folder))?;
        Some(folders.get(..at)?.join("/"))
    };
    files(tree).filter_map(root).min_by_key(|root| {
        (
            root.matches('/').count() + usize::from(!root.is_empty()),
            root.clone(),
        )
    })
}
