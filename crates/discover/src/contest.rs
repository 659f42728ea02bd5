//! Decides whose data a folder is if it looks like data of several applications. A single stray
//! file of another program must not change whose data it is
//! (`docs/loaders/versions.md#whose-data-a-folder-is`).

use std::collections::{BTreeMap, BTreeSet};

use super::evidence::{Evidence, evidence};
use super::layout::Sign;
use super::roots::{DataRoot, Meant};
use super::{Layout, Listing};
use mhlint_diag::Application;

/// What suggests that a folder is data of this application, while other applications have claims on
/// the folder, too.
struct Claim {
    application: Application,
    sign: Sign,
    evidence: Evidence,
}

/// Removes from `signs` the applications that lose a folder. The winners of a folder are the
/// applications with many signs there. If there are none, they are those with certain evidence, or
/// all if none has it; of several winners only those whose data are at hand, if there are any. An
/// application that the user named with `--app` never loses a folder.
///
/// Returns the users' folders that certainly belong to two applications which share such folders.
pub(super) fn settle(
    signs: &mut BTreeMap<DataRoot, Sign>,
    listing: &Listing<'_>,
    meant: Meant<'_>,
) -> BTreeSet<DataRoot> {
    let mut by_path: BTreeMap<&str, Vec<(Application, Sign)>> = BTreeMap::new();
    for (root, sign) in &*signs {
        by_path
            .entry(&root.path)
            .or_default()
            .push((root.application, *sign));
    }
    let (mut lost, mut shared) = (Vec::new(), BTreeSet::new());
    for (path, own) in by_path.into_iter().filter(|(_, own)| is_contested(own)) {
        let claim = |(application, sign)| Claim {
            application,
            sign,
            evidence: evidence(listing, path, application),
        };
        let claims: Vec<Claim> = own.into_iter().map(claim).collect();
        let winners = winners(&claims, meant);
        let root = |application| DataRoot {
            path: path.to_owned(),
            application,
        };
        for claim in &claims {
            let is_certain = claim.evidence.is_certain && winners.contains(&claim.application);
            if is_certain && claims.iter().all(|claim| claim.sign < Sign::Strong) {
                shared.insert(root(claim.application));
            }
            if !winners.contains(&claim.application) && !meant.named.contains(&claim.application) {
                lost.push((root(claim.application), winners.clone()));
            }
        }
    }
    for (root, winners) in lost {
        // An application that shares users' folders with a winner may still have files there.
        if winners
            .iter()
            .any(|winner| share_users(*winner, root.application))
        {
            signs.entry(root).and_modify(|sign| *sign = Sign::Faint);
        } else {
            signs.remove(&root);
        }
    }
    shared
}

/// Whether the applications that claim a folder compete for it. Two applications that share users'
/// folders do not compete if both have faint signs only: the files inside tell them apart later.
fn is_contested(claims: &[(Application, Sign)]) -> bool {
    let is_faint = claims.iter().all(|(_, sign)| *sign == Sign::Faint);
    claims.len() > 1
        && !(is_faint && are_two_that_share(claims.iter().map(|(application, _)| *application)))
}

fn are_two_that_share(applications: impl Iterator<Item = Application>) -> bool {
    matches!(applications.collect::<Vec<_>>().as_slice(), [one, other] if share_users(*one, *other))
}

pub(super) fn share_users(one: Application, other: Application) -> bool {
    Layout::of(one).shares_roots_of == Some(other) || Layout::of(other).shares_roots_of == Some(one)
}

/// The applications that win a folder. An application with few signs is a stray if an application
/// that shares no folders with it has many signs.
fn winners(claims: &[Claim], meant: Meant<'_>) -> BTreeSet<Application> {
    let is_stray = |claim: &&Claim| {
        let mut others = claims
            .iter()
            .filter(|other| other.application != claim.application);
        let is_third = |other: &Claim| !share_users(other.application, claim.application);
        !claim.is_much(claims)
            && others.any(|other| is_third(other) && other.evidence.found >= other.much())
    };
    let left: Vec<&Claim> = claims.iter().filter(|claim| !is_stray(claim)).collect();
    winners_of(
        &if left.is_empty() {
            claims.iter().collect()
        } else {
            left
        },
        meant,
    )
}

fn winners_of(claims: &[&Claim], meant: Meant<'_>) -> BTreeSet<Application> {
    let all = || claims.iter().map(|claim| claim.application);
    let is_shared =
        are_two_that_share(all()) && claims.iter().all(|claim| claim.sign < Sign::Strong);
    let are_much: BTreeSet<Application> = claims
        .iter()
        .filter(|claim| !is_shared && claim.is_much(claims.iter().copied()))
        .map(|claim| claim.application)
        .collect();
    let certain = claims
        .iter()
        .copied()
        .filter(|claim| claim.evidence.is_certain);
    if !are_much.is_empty() {
        // If one application has many signs, a single file of another program is a stray. Files
        // that users of two applications have alike are no strays.
        let is_of_user = |claim: &&Claim| {
            claim.sign < Sign::Strong
                && are_much
                    .iter()
                    .any(|one| share_users(*one, claim.application))
        };
        let of_users = certain.filter(is_of_user).map(|claim| claim.application);
        return of_users.chain(are_much.iter().copied()).collect();
    }
    let certain: BTreeSet<Application> = certain.map(|claim| claim.application).collect();
    if certain.is_empty() && is_shared {
        return all().collect();
    }
    let left = if certain.is_empty() {
        all().collect()
    } else {
        certain
    };
    let known: BTreeSet<Application> = left
        .iter()
        .copied()
        .filter(|one| meant.asked.contains(one) || meant.at_hand.contains(one))
        .collect();
    if known.is_empty() || is_shared {
        left
    } else {
        known
    }
}

/// With this many signs, stray files cannot be the reason.
const MUCH: usize = 3;
/// The same for `MakeHuman` 2: two are enough, because it has a base mesh and folders with the name
/// of that mesh.
const MUCH_OF_MAKEHUMAN2: usize = 2;

impl Claim {
    /// Whether the application has many signs. Signs that users' folders of two applications have
    /// alike do not count if the other application is among `claims`.
    fn is_much<'c>(&self, claims: impl IntoIterator<Item = &'c Self>) -> bool {
        let has_partner = claims
            .into_iter()
            .any(|other| share_users(self.application, other.application));
        let Evidence { found, alike, .. } = self.evidence;
        found - if has_partner { alike } else { 0 } >= self.much()
    }

    /// How many signs count as many.
    const fn much(&self) -> usize {
        if matches!(self.application, Application::Makehuman2) {
            MUCH_OF_MAKEHUMAN2
        } else {
            MUCH
        }
    }
}
