//! Which data roots lie over which: system data below, user data on top, for each application on
//! its own.

use std::collections::{BTreeMap, BTreeSet};

use super::data::{Data, Loaded};
use super::place::Place;
use mhlint_diag::Application;
use mhlint_discover::{Kind, Layout, Role};
use mhlint_repo::{Layer, Layers};

/// The parts that a data root plays, for each application whose data it is.
pub(super) type Roles = Vec<(Application, Role)>;

/// The roles of data roots that are checked together.
pub(super) fn roles(places: &[&Place<'_>]) -> Vec<Roles> {
    let mut roles: Vec<Roles> = places.iter().map(|_| Roles::new()).collect();
    for application in Application::ALL {
        let layout = Layout::of(application);
        let numbered = places
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, place)| place.is_of(application));
        // What is in a zip is put into the user's folder.
        let role = |place: &Place<'_>| {
            if place.pack.is_some() {
                Role::User
            } else {
                (layout.role)(&place.below)
            }
        };
        let mut own: Vec<(usize, Role)> = numbered.map(|(at, place)| (at, role(place))).collect();
        let is_system_of_two = |at: usize| {
            places
                .get(at)
                .is_some_and(|one| (layout.is_system_of_two)(&one.below))
        };
        choose_system(&mut own, is_system_of_two);
        demote(&mut own, |at| {
            places
                .get(at)
                .map(|place| Owners::of(place, application))
                .unwrap_or_default()
        });
        for (at, role) in own {
            roles
                .get_mut(at)
                .into_iter()
                .for_each(|roles| roles.push((application, role)));
        }
    }
    roles
}

/// Where no root is the system for sure, the only one that may be is.
fn choose_system(roles: &mut [(usize, Role)], is_system_of_two: impl Fn(usize) -> bool) {
    if roles.len() > 1 && roles.iter().all(|(_, role)| *role != Role::System) {
        let mut systems = roles
            .iter_mut()
            .filter(|(at, role)| *role == Role::Both && is_system_of_two(*at));
        if let (Some((_, only)), None) = (systems.next(), systems.next()) {
            *only = Role::System;
        }
    }
}

/// The base meshes that a root has, and those that it has sliders or targets for.
#[derive(Default)]
struct Owners<'p> {
    has: BTreeSet<&'p str>,
    adds_to: BTreeSet<&'p str>,
}

impl<'p> Owners<'p> {
    fn of(place: &'p Place<'_>, application: Application) -> Self {
        let mut owners = Self::default();
        let uses = place
            .below
            .iter()
            .flat_map(|one| &one.uses)
            .filter(|one| one.application == application);
        for one in uses {
            let Some(owner) = one.owner.as_deref() else {
                continue;
            };
            match one.kind {
                Kind::BaseJson | Kind::BaseMesh | Kind::MeshArchive => {
                    owners.has.insert(owner);
                }
                Kind::Target | Kind::ModellingJson | Kind::TargetCategories => {
                    owners.adds_to.insert(owner);
                }
                _ => {}
            }
        }
        owners
    }
}

/// A root that adds to a base mesh of another system, which it does not have itself, is a user's,
/// whatever else it has.
fn demote<'p>(roles: &mut [(usize, Role)], owners: impl Fn(usize) -> Owners<'p>) {
    let systems: Vec<usize> = roles
        .iter()
        .filter(|(_, role)| *role == Role::System)
        .map(|(at, _)| *at)
        .collect();
    if systems.len() < 2 {
        return;
    }
    let all: Vec<(usize, Owners<'p>)> = systems.into_iter().map(|at| (at, owners(at))).collect();
    let held: BTreeSet<&str> = all.iter().flat_map(|(_, own)| &own.has).copied().collect();
    let leans = |(_, own): &(usize, Owners<'p>)| {
        let mut added = own.adds_to.difference(&own.has);
        added.any(|base| held.contains(base))
    };
    let users: BTreeSet<usize> = all
        .iter()
        .filter(|one| leans(one))
        .map(|(at, _)| *at)
        .collect();
    // Two that lean on each other are no layers.
    if users.len() < all.len() {
        roles
            .iter_mut()
            .filter(|(at, _)| users.contains(at))
            .for_each(|(_, role)| *role = Role::User);
    }
}

/// A root to check, and what each application sees it with.
pub(crate) struct Stack<'a, 't> {
    pub(crate) root: &'a Loaded<'t>,
    pub(crate) seen: Vec<(Application, Layers<'a>)>,
}

impl<'t> Data<'t> {
    /// The repositories to check with their numbers, in order of the roots; those together that are
    /// the same files.
    pub(crate) fn groups(&self) -> Vec<Vec<(usize, Stack<'_, 't>)>> {
        let mut groups: Vec<Vec<(usize, Stack<'_, 't>)>> = Vec::new();
        let mut known = BTreeMap::new();
        for (number, stack) in self.stacks_of(0..self.roots.len()) {
            let of_files = stack.root.place.files_key();
            let new = groups.len();
            let group = of_files.map_or(new, |files| *known.entry(files).or_insert(new));
            match groups.get_mut(group) {
                Some(group) => group.push((number, stack)),
                None => groups.push(vec![(number, stack)]),
            }
        }
        groups
    }

    /// The repositories to check, in order of the roots.
    pub(crate) fn stacks(&self) -> Vec<Stack<'_, 't>> {
        self.stacks_of(0..self.roots.len())
            .into_iter()
            .map(|(_, stack)| stack)
            .collect()
    }

    /// The repositories with these numbers, with their numbers. A root lies over that of the
    /// systems that has data of the same application.
    pub(crate) fn stacks_of<'a>(
        &'a self,
        numbers: impl IntoIterator<Item = usize>,
    ) -> Vec<(usize, Stack<'a, 't>)> {
        let layers = |root: &'a Loaded<'t>, application, role| {
            let given = self
                .given(application)
                .filter(|_| !root.alone.contains(&application));
            let given = given.map(|given| &given.layer);
            let below = || self.nearest_system(root, application);
            let (system, user) = match (given, role) {
                (Some(given), _) => (Some(given), Some(&root.layer)),
                (None, Role::System) => (Some(&root.layer), None),
                (None, Role::Both) => (Some(below().unwrap_or(&root.layer)), Some(&root.layer)),
                (None, Role::User) => (below(), Some(&root.layer)),
            };
            let looks_beside = user.is_none() || Layout::of(application).has_second_user;
            let beside = if looks_beside {
                self.user_beside(application, root)
            } else {
                None
            };
            (
                application,
                Layers {
                    system,
                    user,
                    beside,
                    checked: &root.layer,
                },
            )
        };
        let stack = |root: &'a Loaded<'t>| {
            let seen = root
                .roles
                .iter()
                .map(|(application, role)| layers(root, *application, *role));
            Stack {
                root,
                seen: seen.collect(),
            }
        };
        let numbers = numbers.into_iter();
        numbers
            .filter_map(|number| Some((number, stack(self.roots.get(number)?))))
            .collect()
    }
}

impl Data<'_> {
    /// The data of the program that `--system` names.
    pub(super) fn given(&self, application: Application) -> Option<&Loaded<'_>> {
        self.systems
            .iter()
            .find(|system| system.role_in(application).is_some())
    }

    /// The roots below which those data are not laid.
    pub(crate) fn standing_alone(&self) -> impl Iterator<Item = (&Layer, Application)> {
        self.roots.iter().flat_map(|root| {
            root.alone
                .iter()
                .map(|application| (&root.layer, *application))
        })
    }

    /// The first of the other roots that are users'.
    fn user_beside(&self, application: Application, own: &Loaded<'_>) -> Option<&Layer> {
        let users = self.around.users.get(&application).into_iter().flatten();
        let mut others = users.filter_map(|number| self.roots.get(*number));
        let other = others.find(|root| !std::ptr::eq(*root, own))?;
        Some(&other.layer)
    }

    /// Of several system roots of an application the one that shares most of the path.
    fn nearest_system(&self, root: &Loaded<'_>, application: Application) -> Option<&Layer> {
        let of = |begins| {
            let key = (application, begins);
            self.around.systems.get(&key)
        };
        let number = beginnings(&root.layer.path).find_map(|begins| of(begins.map(str::to_owned)));
        Some(&self.roots.get(*number?)?.layer)
    }
}

/// Which of the roots lie below or beside others.
#[derive(Default)]
pub(super) struct Around {
    /// For each application the last of the systems whose path begins with these folders.
    systems: BTreeMap<(Application, Option<String>), usize>,
    /// For each application the first two of the users' roots: one of them is another one.
    users: BTreeMap<Application, Vec<usize>>,
}

impl Around {
    pub(super) fn of(roots: &[Loaded<'_>]) -> Self {
        let mut around = Self::default();
        for (number, root) in roots.iter().enumerate() {
            for (application, role) in &root.roles {
                if *role == Role::System {
                    let begins = beginnings(&root.layer.path);
                    let keys = begins.map(|begins| (*application, begins.map(str::to_owned)));
                    around.systems.extend(keys.map(|key| (key, number)));
                } else if !root.place.is_loose {
                    let users = around.users.entry(*application).or_default();
                    if users.len() < 2 {
                        users.push(number);
                    }
                }
            }
        }
        around
    }
}

/// The path, those of the folders above it, the nearest first, and at last what every path begins
/// with.
fn beginnings(path: &str) -> impl Iterator<Item = Option<&str>> {
    let above = path.rmatch_indices('/').map(|(at, _)| path.get(..at));
    std::iter::once(Some(path)).chain(above).chain([None])
}
