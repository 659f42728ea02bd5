//! Folders that look like data of several applications: one stray file makes nobody's data those of another program
//! (formats/versions.md §1).

use std::collections::{BTreeMap, BTreeSet};

use super::evidence::evidence;
use super::layout::Sign;
use super::listing::at;
use super::roots::DataRoot;
use super::{Layout, Listing};
use crate::diag::Application;

/// Leaves each folder to the applications that something certain speaks for, of several to those that are `meant`; where
/// nothing is certain these decide alone. An application that is asked for by name keeps what it has.
pub(super) fn settle(
    signs: &mut BTreeMap<DataRoot, Sign>,
    listing: &Listing<'_>,
    meant: &[Application],
    named: &[Application],
) {
    let mut claims: BTreeMap<&str, Vec<(Application, Sign)>> = BTreeMap::new();
    for (root, sign) in &*signs {
        claims.entry(&root.path).or_default().push((root.application, *sign));
    }
    let mut lost = Vec::new();
    for (path, claims) in claims.into_iter().filter(|(_, claims)| is_contested(claims)) {
        let winners = winners(listing, path, &claims, meant);
        let losers = claims.iter().filter(|(one, _)| !winners.contains(one) && !named.contains(one));
        lost.extend(losers.map(|(one, _)| (DataRoot { path: path.to_owned(), application: *one }, winners.clone())));
    }
    for (root, winners) in lost {
        // Who shares folders of users with a winner may have some there.
        if winners.iter().any(|winner| share_users(*winner, root.application)) {
            signs.entry(root).and_modify(|sign| *sign = Sign::Faint);
        } else {
            signs.remove(&root);
        }
    }
}

/// Whether it matters whose it is.
fn is_contested(claims: &[(Application, Sign)]) -> bool {
    claims.len() > 1 && claims.iter().any(|(_, sign)| *sign >= Sign::Weak)
}

/// Whether only two claim it that share folders of users, none with what a program has: what is in it tells them apart.
fn is_shared(claims: &[(Application, Sign)]) -> bool {
    let share = |(one, other): (&(Application, Sign), &(Application, Sign))| share_users(one.0, other.0);
    let are_two = claims.len() == 2 && claims.first().zip(claims.get(1)).is_some_and(share);
    are_two && claims.iter().all(|(_, sign)| *sign < Sign::Strong)
}

fn share_users(one: Application, other: Application) -> bool {
    Layout::of(one).shares_roots_of == Some(other) || Layout::of(other).shares_roots_of == Some(one)
}

fn winners(
    listing: &Listing<'_>,
    path: &str,
    claims: &[(Application, Sign)],
    meant: &[Application],
) -> BTreeSet<Application> {
    let all: BTreeSet<Application> = claims.iter().map(|(application, _)| *application).collect();
    let is_certain = |application: &Application| evidence(listing, path, *application).is_certain;
    let certain: BTreeSet<Application> = all.iter().copied().filter(is_certain).collect();
    if certain.is_empty() && is_shared(claims) {
        return all;
    }
    let mut left = if certain.is_empty() { all } else { certain };
    let has = |folder: &str| listing.has_folder(&at(path, folder));
    // A base mesh of MakeHuman 2 without targets, among what only the others have.
    if left.len() > 1 && !has("target") && (has("3dobjs") || has("targets")) {
        left.remove(&Application::Makehuman2);
    }
    // A table of the add-on without anything else that it has for itself.
    if left.len() > 1 && has("mesh_metadata") && !has("node_trees") && !has("rigs/standard") {
        left.remove(&Application::Mpfb);
    }
    let known: BTreeSet<Application> = left.iter().copied().filter(|one| meant.contains(one)).collect();
    if known.is_empty() { left } else { known }
}
