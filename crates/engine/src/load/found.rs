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
    for own in Application::ALL {
        let owner = Layout::of(own).shares_roots_of;
        if let Some(owner) = owner.filter(|_| !named.contains(&own)) {
            leave_to_home(found, own, owner);
        }
    }
}

fn leave_to_home(found: &mut [Found<'_>], own: Application, owner: Application) {
    let has =
        |layouts: &[&'static Layout], one| layouts.iter().any(|layout| layout.application == one);
    let are_both = |layouts: &[&'static Layout]| has(layouts, own) && has(layouts, owner);
    let all = |found: &[Found<'_>]| {
        found
            .iter()
            .flat_map(|(_, roots)| roots.values())
            .any(|one| are_both(one))
    };
    if !all(found) {
        return;
    }
    let certain: Vec<BTreeSet<(String, Application)>> = found
        .iter()
        .map(|(input, roots)| certain(&input.tree, roots))
        .collect();
    let is_users = |tree: &Tree, path: &str| {
        let layout = Layout::of(own);
        (layout.role)(&candidates(tree, path, &[layout])) != Role::System
    };
    let has_home = found.iter().zip(&certain).any(|((input, roots), certain)| {
        roots.iter().any(|(path, layouts)| {
            let is_own = has(layouts, own) && !has(layouts, owner);
            is_own && certain.contains(&(path.clone(), own)) && is_users(&input.tree, path)
        })
    });
    for ((_, roots), certain) in found.iter_mut().zip(&certain).filter(|_| has_home) {
        let is = |path: &String, one| certain.contains(&(path.clone(), one));
        for (path, layouts) in roots.iter_mut().filter(|(_, layouts)| are_both(layouts)) {
            if is(path, owner) && !is(path, own) {
                layouts.retain(|layout| layout.application != own);
            }
        }
    }
}

/// The roots with the applications that certainly have them.
fn certain(
    tree: &Tree,
    roots: &BTreeMap<String, Vec<&'static Layout>>,
) -> BTreeSet<(String, Application)> {
    let peek = |path: &str| look_into(tree, path);
    let listing = listing(tree).with_contents(&peek);
    let all = roots
        .iter()
        .flat_map(|(path, layouts)| layouts.iter().map(move |one| (path, one.application)));
    let certain = all.filter(|(path, one)| evidence(&listing, path, *one).is_certain);
    certain.map(|(path, one)| (path.clone(), one)).collect()
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
