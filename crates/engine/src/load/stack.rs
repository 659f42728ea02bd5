//! Which data roots lie over which: system data below, user data on top, for each application on
//! its own.

use std::collections::BTreeSet;

use super::data::{Data, Loaded};
use super::place::Place;
use mhlint_diag::Application;
use mhlint_discover::{Kind, Layout, Role};
use mhlint_repo::{Layer, Layers};

/// The parts that a data root plays, for each application whose data it is.
pub(super) type Roles = Vec<(Application, Role)>;

/// The roles of data roots that are checked together.
pub(super) fn roles<'a, 't: 'a>(places: impl Iterator<Item = &'a Place<'t>> + Clone) -> Vec<Roles> {
    let mut roles: Vec<Roles> = places.clone().map(|_| Roles::new()).collect();
    for application in Application::ALL {
        let layout = Layout::of(application);
        let numbered = places
            .clone()
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
                .clone()
                .nth(at)
                .is_some_and(|one| (layout.is_system_of_two)(&one.below))
        };
        choose_system(&mut own, is_system_of_two);
        demote(&mut own, |at| {
            places
                .clone()
                .nth(at)
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
    let leans = |(at, own): &(usize, Owners<'p>)| {
        let added = own.adds_to.difference(&own.has);
        let others = all.iter().filter(|(other, _)| other != at);
        added
            .into_iter()
            .any(|base| others.clone().any(|(_, other)| other.has.contains(base)))
    };
    let users: Vec<usize> = all
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
        for (number, stack) in self.stacks_of(|_| true) {
            let is_same = |group: &&mut Vec<(usize, Stack<'_, 't>)>| {
                group
                    .first()
                    .is_some_and(|(_, first)| first.root.place.has_files_of(&stack.root.place))
            };
            match groups.iter_mut().find(is_same) {
                Some(group) => group.push((number, stack)),
                None => groups.push(vec![(number, stack)]),
            }
        }
        groups
    }

    /// The repositories to check, in order of the roots.
    pub(crate) fn stacks(&self) -> Vec<Stack<'_, 't>> {
        self.stacks_of(|_| true)
            .into_iter()
            .map(|(_, stack)| stack)
            .collect()
    }

    /// Those of the repositories whose numbers are asked for, with their numbers. A root lies over
    /// that of the systems that has data of the same application.
    pub(crate) fn stacks_of<'a>(
        &'a self,
        is_asked: impl Fn(usize) -> bool,
    ) -> Vec<(usize, Stack<'a, 't>)> {
        let found: Vec<&Loaded<'_>> = self
            .roots
            .iter()
            .filter(|root| root.roles.iter().any(|(_, role)| *role == Role::System))
            .collect();
        let layers = |root: &'a Loaded<'t>, application, role| {
            let given = self
                .given(application)
                .filter(|_| !root.alone.contains(&application));
            let given = given.map(|given| &given.layer);
            let below = || nearest_system(&found, root, application);
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
        let asked = self
            .roots
            .iter()
            .enumerate()
            .filter(|(number, _)| is_asked(*number));
        asked.map(|(number, root)| (number, stack(root))).collect()
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
        let plays =
            |root: &&Loaded<'_>| matches!(root.role_in(application), Some(Role::User | Role::Both));
        let others = self
            .roots
            .iter()
            .filter(|root| !root.place.is_loose && !std::ptr::eq(*root, own));
        others.into_iter().find(plays).map(|root| &root.layer)
    }
}

/// Of several system roots of an application the one that shares most of the path.
fn nearest_system<'a>(
    found: &[&'a Loaded<'_>],
    root: &Loaded<'_>,
    application: Application,
) -> Option<&'a Layer> {
    let shared = |other: &Loaded<'_>| {
        let pairs = other.layer.path.split('/').zip(root.layer.path.split('/'));
        pairs.take_while(|(a, b)| a == b).count()
    };
    let systems = found
        .iter()
        .filter(|other| other.role_in(application) == Some(Role::System));
    systems
        .max_by_key(|other| shared(other))
        .map(|other| &other.layer)
}
