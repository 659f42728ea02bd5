//! Which data roots lie over which: system data below, user data on top.

use super::data::Loaded;
use super::place::Place;
use crate::discover::Role;
use crate::repo::Layer;

/// The roles of data roots that are judged together. Where none is the system for sure, the only one that may be is.
pub(super) fn roles<'a, 't: 'a>(places: impl Iterator<Item = &'a Place<'t>> + Clone) -> Vec<Role> {
    let mut roles: Vec<Role> = places.clone().map(Place::role).collect();
    if roles.len() > 1 && !roles.contains(&Role::System) {
        let mut systems =
            places.zip(&mut roles).filter(|(place, role)| **role == Role::Both && place.is_system_of_two());
        if let (Some((_, only)), None) = (systems.next(), systems.next()) {
            *only = Role::System;
        }
    }
    roles
}

/// System layer, user layer and judged root of every repository to judge.
pub(in crate::engine) type Stack<'a, 't> = (Option<&'a Layer>, Option<&'a Layer>, &'a Loaded<'t>);

/// The repositories that `loaded` makes. With `system` given, every root lies over it.
pub(in crate::engine) fn stacks<'a, 't>(loaded: &'a [Loaded<'t>], system: Option<&'a Layer>) -> Vec<Stack<'a, 't>> {
    let stack = |root: &'a Loaded<'t>| -> Stack<'a, 't> {
        if let Some(system) = system {
            return (Some(system), Some(&root.layer), root);
        }
        let below = nearest_system(loaded, root);
        match (root.role, below) {
            (Role::System, _) => (Some(&root.layer), None, root),
            (Role::Both, None) => (Some(&root.layer), Some(&root.layer), root),
            (Role::Both | Role::User, Some(below)) => (Some(below), Some(&root.layer), root),
            (Role::User, None) => (None, Some(&root.layer), root),
        }
    };
    loaded.iter().map(stack).collect()
}

/// Of several system roots of its application the one that shares most of the path.
fn nearest_system<'a>(loaded: &'a [Loaded<'_>], root: &Loaded<'_>) -> Option<&'a Layer> {
    let shared = |other: &Loaded<'_>| {
        let pairs = other.layer.path.split('/').zip(root.layer.path.split('/'));
        pairs.take_while(|(a, b)| a == b).count()
    };
    let applications = |layer: &Layer| layer.layouts.iter().map(|layout| layout.application).collect::<Vec<_>>();
    let own = applications(&root.layer);
    let serves = |other: &Layer| applications(other).iter().any(|application| own.contains(application));
    let systems = loaded.iter().filter(|other| other.role == Role::System && serves(&other.layer));
    systems.max_by_key(|other| shared(other)).map(|other| &other.layer)
}
