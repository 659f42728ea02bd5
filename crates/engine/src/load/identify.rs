//! What each data root was taken for: kind of place, version, and why
//! (`docs/loaders/versions.md#whose-data-a-folder-is`).

use super::data::Loaded;
use super::found::look_into;
use super::place::Place;
use mhlint_config::Config;
use mhlint_diag::{Application, Identity, PlaceKind, Sign, Speaks, Version};
use mhlint_discover::{Candidate, Evidence, Kind, Layout, Listing, Paths, Role, evidence, lacks};
use mhlint_repo::{FileFacts, Layer};
use mhlint_source::EntryKind;

/// Says of a data root what each of its applications takes it for.
pub(super) fn identify(root: &mut Loaded<'_>, options: &Config) {
    let place = &root.place;
    let of = |kind: EntryKind| place.below.iter().filter(move |one| one.entry.kind == kind);
    let paths = |kind| of(kind).map(|one| one.entry.path.as_str());
    let peek = |path: &str| look_into(place.tree, path);
    let look = |rel: &str| look_into(place.tree, &join(&place.root, rel));
    let listing =
        Listing::of(paths(EntryKind::File), paths(EntryKind::Folder)).with_contents(&peek);
    let identities =
        root.roles.iter().map(|(application, role)| {
            let layout = Layout::of(*application);
            let paths = Paths::of(files(place), mesh(&root.layer, *application), &look);
            let own = options
                .versions
                .iter()
                .find(|version| version.application() == *application)
                .copied();
            // In the folder of a user files of all versions meet.
            let is_programs = *role != Role::User && !place.is_supposed();
            let found = || {
                Version::named(
                    *application,
                    (layout.version)(&paths).filter(|_| is_programs)?,
                )
            };
            let Evidence {
                signs, is_certain, ..
            } = if place.is_supposed() {
                Evidence::default()
            } else {
                evidence(&listing, &place.root, *application)
            };
            let mut evidence: Vec<Sign> = signs
                .into_iter()
                .map(|sign| speaks(*application, Speaks::For, sign))
                .collect();
            if !evidence.is_empty() {
                let others = Application::ALL
                    .into_iter()
                    .filter(|other| !place.is_of(*other));
                evidence.extend(others.map(|other| {
                    speaks(other, Speaks::Against, lacks(&listing, &place.root, other))
                }));
            }
            let kind = Some(kind(place, &paths, *application, *role));
            let (version, is_version_asked) = (own.or_else(found), own.is_some());
            (
                *application,
                Identity {
                    kind,
                    version,
                    evidence,
                    is_certain,
                    is_version_asked,
                },
            )
        });
    root.layer.identities = identities.collect();
}

fn speaks(application: Application, speaks: Speaks, sign: String) -> Sign {
    Sign {
        application,
        speaks,
        sign,
    }
}

/// What kind of place it is.
fn kind(place: &Place<'_>, paths: &Paths<'_>, application: Application, role: Role) -> PlaceKind {
    if place.pack.is_some() {
        return PlaceKind::Pack;
    }
    if place.is_loose {
        let is_asset = |kind: Kind| matches!(kind, Kind::Clothes | Kind::Skeleton);
        let assets = place
            .below
            .iter()
            .filter(|one| is_asset(one.kind()))
            .count();
        return if assets == 1 {
            PlaceKind::Asset
        } else {
            PlaceKind::Loose
        };
    }
    match role {
        Role::Both => PlaceKind::User,
        Role::System if (Layout::of(application).is_release)(paths) => PlaceKind::Release,
        Role::System => PlaceKind::Program,
        Role::User if is_users(&place.below, application) => PlaceKind::User,
        Role::User => PlaceKind::Pack,
    }
}

/// Whether what lies in a data root is a pack.
pub(super) fn is_pack(below: &[Candidate<'_>], layout: &Layout) -> bool {
    (layout.role)(below) == Role::User && !is_users(below, layout.application)
}

/// Whether it has what only the folder of a user has: a pack is assets alone.
fn is_users(below: &[Candidate<'_>], application: Application) -> bool {
    const OWN: [&str; 8] = [
        "custom",
        "contarget",
        "dbcache",
        "downloads",
        "exports",
        "grab",
        "config",
        "models",
    ];
    let is_own = |rel: &str| match rel.split('/').collect::<Vec<_>>().as_slice() {
        [top, _, ..] if OWN.contains(top) => true,
        ["targets", "custom", ..] => true,
        parts => (Layout::of(application).is_of_user)(parts),
    };
    below.iter().any(|one| one.is_loose || is_own(&one.rel))
}

fn files<'p>(place: &'p Place<'_>) -> impl Iterator<Item = &'p str> {
    place
        .below
        .iter()
        .filter(|one| one.is_file())
        .map(|one| &*one.rel)
}

/// Vertices and texture coordinates of the base mesh.
fn mesh(layer: &Layer, application: Application) -> (usize, usize) {
    let mut files = layer
        .files
        .values()
        .filter(|file| file.kind_in(application).is_base_mesh());
    files
        .find_map(FileFacts::mesh)
        .map_or((0, 0), |mesh| (mesh.positions.len(), mesh.uvs.len()))
}

fn join(root: &str, rel: &str) -> String {
    if root.is_empty() {
        rel.to_owned()
    } else {
        format!("{root}/{rel}")
    }
}
