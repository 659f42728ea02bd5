//! Where the data roots of a tree are.

use std::collections::{BTreeMap, BTreeSet};

use super::roots::Found;
use mhlint_diag::{Application, grouped};
use mhlint_discover::{
    Layout, Listing, Meant, Role, candidates, evidence, find_roots, is_of_macos,
};
use mhlint_source::{EntryKind, Limits, Tree};

/// The data roots in a tree of the applications of which `wanted` holds, by path; `asked` are those
/// asked for by name.
pub(super) fn roots_of(
    tree: &Tree,
    asked: &[Application],
    wanted: impl Fn(Application) -> bool,
) -> BTreeMap<String, Vec<&'static Layout>> {
    roots_beside(
        tree,
        Meant {
            asked,
            named: asked,
            at_hand: &[],
        },
        &BTreeSet::new(),
        wanted,
    )
}

/// The same beside data of other applications in another tree, where the run knows base meshes of
/// these names.
pub(super) fn roots_beside(
    tree: &Tree,
    meant: Meant<'_>,
    bases: &BTreeSet<String>,
    wanted: impl Fn(Application) -> bool,
) -> BTreeMap<String, Vec<&'static Layout>> {
    let peek = |path: &str| look_into(tree, path);
    let listing = listing(tree)
        .with_contents(&peek)
        .with_bases(bases.iter().map(String::as_str));
    let wanted = find_roots(&listing, meant)
        .into_iter()
        .filter(|root| wanted(root.application));
    let roots = grouped(wanted.map(|root| (root.path, Layout::of(root.application))));
    let mut roots: BTreeMap<String, Vec<&'static Layout>> = roots.into_iter().collect();
    for (path, layouts) in &mut roots {
        leave_to_program(tree, &listing, path, layouts, meant.named);
    }
    roots
}

/// The data of a program are no folder of users that another application shares with that, unless
/// they certainly are one.
fn leave_to_program(
    tree: &Tree,
    listing: &Listing<'_>,
    path: &str,
    layouts: &mut Vec<&'static Layout>,
    named: &[Application],
) {
    let role = |layout: &Layout| (layout.role)(&candidates(tree, path, &[layout]));
    let all = layouts.clone();
    layouts.retain(|own| {
        let owner = all
            .iter()
            .find(|other| own.shares_roots_of == Some(other.application));
        let Some(owner) = owner.filter(|_| !named.contains(&own.application)) else {
            return true;
        };
        let is_theirs = role(owner) == Role::System && role(own) == Role::User;
        !is_theirs || evidence(listing, path, own.application).is_certain
    });
}

/// An application whose user has a home of his own here reads that of another application only
/// where it is asked for: what certainly is a home of the other one is left to that.
pub(super) fn leave_to_homes(found: &mut [Found<'_>], named: &[Application]) {
    for own in Application::ALL
        .into_iter()
        .filter(|own| !named.contains(own))
    {
        let Some(owner) = Layout::of(own).shares_roots_of else {
            continue;
        };
        let is_certain = |tree: &Tree, path: &str, application| {
            evidence(&listing(tree), path, application).is_certain
        };
        let is_of = |layouts: &[&'static Layout], one| {
            layouts.iter().any(|layout| layout.application == one)
        };
        let is_home = |tree: &Tree, path: &str, layouts: &[&'static Layout]| {
            let is_users = || {
                (Layout::of(own).role)(&candidates(tree, path, &[Layout::of(own)])) != Role::System
            };
            is_of(layouts, own)
                && !is_of(layouts, owner)
                && is_users()
                && is_certain(tree, path, own)
        };
        let has_home = |(input, roots): &Found<'_>| {
            roots
                .iter()
                .any(|(path, all)| is_home(&input.tree, path, all))
        };
        if !found.iter().any(has_home) {
            continue;
        }
        for (input, roots) in &mut *found {
            let both = roots
                .iter_mut()
                .filter(|(_, layouts)| is_of(layouts, own) && is_of(layouts, owner));
            let theirs = both.filter(|(path, _)| is_certain(&input.tree, path, owner));
            let theirs = theirs.filter(|(path, _)| !is_certain(&input.tree, path, own));
            theirs.for_each(|(_, layouts)| layouts.retain(|layout| layout.application != own));
        }
    }
}

/// The paths of a tree.
pub(super) fn listing(tree: &Tree) -> Listing<'_> {
    let of = |kind: EntryKind| {
        tree.entries()
            .iter()
            .filter(move |entry| entry.kind == kind && !is_of_macos(&entry.path))
    };
    let paths = |kind| of(kind).map(|entry| entry.path.as_str());
    Listing::of(paths(EntryKind::File), paths(EntryKind::Folder))
}

/// Bytes from which on a file is too large to say whose it is.
const TELLING: u64 = 1 << 20;

/// What is in a file that may say whose data these are.
pub(super) fn look_into(tree: &Tree, path: &str) -> Option<Vec<u8>> {
    let entry = tree
        .entry(path)
        .filter(|entry| entry.kind == EntryKind::File && entry.size <= TELLING)?;
    tree.read(entry, &Limits::default()).ok()
}
