//! Which data roots lie over which: system data below, user data on top.

use super::data::Loaded;
use super::layer::Place;
use crate::repo::Layer;

/// The part a data root plays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::engine) enum Role {
    /// Holds base meshes and no `contarget/`: what the application calls its system data.
    System,
    /// Holds base meshes and `contarget/`: a user's folder with bases of its own, or both in one.
    Both,
    /// Holds no base mesh: a user's folder.
    User,
}

impl Role {
    /// The role of a data root.
    pub(in crate::engine) fn of(place: Place<'_>) -> Self {
        let has = |test: fn(&[&str]) -> bool| {
            let mut below = place.below().map(|(_, rel)| rel.split('/').collect::<Vec<_>>());
            below.any(|parts| test(&parts))
        };
        let meshes = has(|parts| matches!(parts, ["base", _, "base.json" | "base.obj"]));
        let contarget = has(|parts| matches!(parts, ["contarget", _, _, ..]));
        match (meshes, contarget) {
            (true, false) => Self::System,
            (true, true) => Self::Both,
            (false, _) => Self::User,
        }
    }
}

/// The roles of data roots that are judged together. `contarget/` is read in the user's folder only: beside another
/// root, the one whose bases have their targets in `target/` is the system, and its `contarget/` counts for nothing.
pub(in crate::engine) fn roles(places: &[Place<'_>]) -> Vec<Role> {
    let mut roles: Vec<Role> = places.iter().map(|place| Role::of(*place)).collect();
    if places.len() > 1 && !roles.contains(&Role::System) {
        let is_system = |(place, role): (&Place<'_>, &Role)| *role == Role::Both && has_own_targets(*place);
        let mut systems =
            (0_usize..).zip(places.iter().zip(&roles)).filter(|(_, root)| is_system(*root)).map(|(at, _)| at);
        if let (Some(only), None) = (systems.next(), systems.next())
            && let Some(role) = roles.get_mut(only)
        {
            *role = Role::System;
        }
    }
    roles
}

/// Whether `target/` has sliders or macros for a base mesh that lies here.
fn has_own_targets(place: Place<'_>) -> bool {
    let paths = || place.below().map(|(_, rel)| rel.split('/').collect::<Vec<_>>());
    let has_mesh = |base: &str| {
        paths().any(|parts| matches!(parts.as_slice(), ["base", name, "base.json" | "base.obj"] if *name == base))
    };
    paths().any(|parts| match parts.as_slice() {
        ["target", base, "macro.json" | "modelling.json"] => has_mesh(base),
        _ => false,
    })
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

/// Of several system roots the one that shares most of the path.
fn nearest_system<'a>(loaded: &'a [Loaded<'_>], root: &Loaded<'_>) -> Option<&'a Layer> {
    let shared = |other: &Loaded<'_>| {
        let pairs = other.layer.path.split('/').zip(root.layer.path.split('/'));
        pairs.take_while(|(a, b)| a == b).count()
    };
    let systems = loaded.iter().filter(|other| other.role == Role::System);
    systems.max_by_key(|other| shared(other)).map(|other| &other.layer)
}
