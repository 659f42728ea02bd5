//! What a run says of the data roots that it checked.

use std::collections::BTreeSet;

use super::error::Error;
use super::load::{Data, shown};
use mhlint_config::Config;
use mhlint_diag::{Identity, Outcome, PlaceKind, RootSummary};
use mhlint_discover::UNKNOWN_BASE;
use mhlint_repo::{FileFacts, View};

/// Says that a repository was checked, and which base meshes it has.
pub(super) fn summarise(view: &View<'_>, outcome: &mut Outcome) {
    let checked = view.layers().checked;
    let own: BTreeSet<&str> = checked
        .files
        .values()
        .filter_map(|file| file.base_in(view.application()))
        .collect();
    // The base mesh of a pack may be elsewhere.
    let import = checked
        .pack
        .as_ref()
        .and_then(|pack| pack.import.as_ref())
        .map(|import| import.base.as_str());
    let names: BTreeSet<&str> = view.body_names().into_iter().chain(import).collect();
    // What lies in no data folder is for a base mesh that may be nowhere at hand.
    let is_own = |name: &&str| own.contains(name) && *name != UNKNOWN_BASE;
    let has_no_bases = checked.is_loose && view.layers().system.is_none();
    let names = if has_no_bases { own.clone() } else { names };
    let bases = names.into_iter().filter(is_own);
    let path = shown(&checked.path).to_owned();
    // What is wrong with a zip as such is no further root.
    let is_known = |root: &RootSummary| root.path == path && root.application == view.application();
    if checked.pack.is_some() && outcome.roots.iter().any(is_known) {
        return;
    }
    outcome.roots.push(RootSummary {
        path,
        application: view.application(),
        bases: bases.map(str::to_owned).collect(),
        identity: identity(view),
    });
}

/// What the data were taken for. Where a part of a program's data is, that it is one.
fn identity(view: &View<'_>) -> Identity {
    let known = view
        .layers()
        .checked
        .identities
        .get(&view.application())
        .cloned();
    let mut identity = known.unwrap_or_default();
    if view.is_partial() {
        identity.kind = Some(PlaceKind::Partial);
    }
    identity
}

/// Refuses `--base` with a name that no data root has.
pub(super) fn check_bases(
    options: &Config,
    data: &Data<'_>,
    outcome: &Outcome,
) -> Result<(), Error> {
    // A zip is imported for any base mesh, also one of which it has nothing.
    let packs = data.roots.iter().filter(|root| root.layer.pack.is_some());
    let of_systems = packs
        .take(1)
        .flat_map(|_| &data.systems)
        .flat_map(|system| system.layer.files.values());
    let of_systems = of_systems
        .filter(|file| file.kind.is_base_mesh())
        .filter_map(FileFacts::base);
    let known = outcome
        .roots
        .iter()
        .flat_map(|root| &root.bases)
        .map(String::as_str);
    let known: BTreeSet<&str> = known.chain(of_systems).collect();
    let unknown = options
        .bases
        .iter()
        .find(|name| !known.contains(name.as_str()));
    unknown
        .filter(|_| outcome.checked_anything())
        .map_or(Ok(()), |name| {
            Err(Error::UnknownBase {
                name: name.clone(),
                known: known.into_iter().map(str::to_owned).collect(),
            })
        })
}
