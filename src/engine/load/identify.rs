//! What each data root was taken for: kind of place, version, and why (formats/versions.md §1, §2).

use std::collections::BTreeSet;
use std::ops::Bound;

use super::data::Loaded;
use super::place::Place;
use super::roots::look_into;
use crate::config::Config;
use crate::diag::{Application, Identity, PlaceKind, Sign, Speaks, Version};
use crate::discover::{Evidence, Kind, Listing, Role, evidence, extension, lacks};
use crate::repo::{FileFacts, Layer};
use crate::source::EntryKind;

/// Says of a data root what each of its applications takes it for.
pub(super) fn identify(root: &mut Loaded<'_>, options: &Config) {
    let place = &root.place;
    let of = |kind: EntryKind| place.below.iter().filter(move |one| one.entry.kind == kind);
    let paths = |kind| of(kind).map(|one| one.entry.path.as_str());
    let peek = |path: &str| look_into(place.tree, path);
    let listing = Listing::of(paths(EntryKind::File), paths(EntryKind::Folder)).with_contents(&peek);
    let identities = root.roles.iter().map(|(application, role)| {
        let own = options.versions.iter().find(|version| version.application() == *application).copied();
        let found = || version(place, &root.layer, *application, *role);
        let Evidence { signs, is_certain } =
            if place.is_supposed() { Evidence::default() } else { evidence(&listing, &place.root, *application) };
        let mut evidence: Vec<Sign> = signs.into_iter().map(|sign| speaks(*application, Speaks::For, sign)).collect();
        if !evidence.is_empty() {
            let others = Application::ALL.into_iter().filter(|other| !place.is_of(*other));
            evidence.extend(
                others.map(|other| speaks(other, Speaks::Against, lacks(&listing, &place.root, other).to_owned())),
            );
        }
        let kind = Some(kind(place, *application, *role));
        (*application, Identity { kind, version: own.or_else(found), evidence, is_certain })
    });
    root.layer.identities = identities.collect();
}

fn speaks(application: Application, speaks: Speaks, sign: String) -> Sign {
    Sign { application, speaks, sign }
}

/// What kind of place it is.
fn kind(place: &Place<'_>, application: Application, role: Role) -> PlaceKind {
    if place.pack.is_some() {
        return PlaceKind::Pack;
    }
    if place.is_loose {
        let is_asset = |kind: Kind| matches!(kind, Kind::Clothes | Kind::Skeleton);
        let assets = place.below.iter().filter(|one| is_asset(one.kind())).count();
        return if assets == 1 { PlaceKind::Asset } else { PlaceKind::Loose };
    }
    match role {
        Role::Both => PlaceKind::User,
        Role::System if is_release(place, application) => PlaceKind::Release,
        Role::System => PlaceKind::Program,
        Role::User if is_users(place, application) => PlaceKind::User,
        Role::User => PlaceKind::Pack,
    }
}

/// Whether most of what is worn, and all targets, come compiled.
fn is_release(place: &Place<'_>, application: Application) -> bool {
    let files = || place.below.iter().filter(|one| one.is_file() && application == Application::Makehuman1);
    let has = |name: &str| files().any(|one| one.rel == name);
    let stems = |wanted: &'static str| -> BTreeSet<&str> {
        let of = files().filter(move |one| extension(&one.rel) == wanted);
        of.filter_map(|one| one.rel.rsplit_once('.').map(|(stem, _)| stem)).collect()
    };
    let (texts, packed) = (stems("mhclo"), stems("mhpxy"));
    has("targets.npz") && has("images.list") || packed.difference(&texts).count() > texts.len()
}

/// Whether it has what only the folder of a user has: a pack is assets alone.
fn is_users(place: &Place<'_>, application: Application) -> bool {
    const OWN: [&str; 8] = ["custom", "contarget", "dbcache", "downloads", "exports", "grab", "config", "models"];
    let is_own = |rel: &str| match rel.split('/').collect::<Vec<_>>().as_slice() {
        [top, _, ..] if OWN.contains(top) => true,
        ["targets", "custom", ..] => true,
        ["rigs", _] => application == Application::Mpfb,
        _ => false,
    };
    place.below.iter().any(|one| one.is_loose || is_own(&one.rel))
}

/// The version of the application that the data of a program are of, where something in them says so. In those of a user
/// files of all versions meet.
fn version(place: &Place<'_>, layer: &Layer, application: Application, role: Role) -> Option<Version> {
    if role != Role::System || place.is_supposed() {
        return None;
    }
    let paths = Paths::of(place);
    let name = match application {
        Application::Makehuman1 => version_of_makehuman1(&paths, layer),
        Application::Makehuman2 => version_of_makehuman2(&paths),
        Application::Mpfb => version_of_mpfb(&paths),
    };
    Version::named(application, name?)
}

/// The paths in a data root, also of what is read later.
struct Paths<'p> {
    place: &'p Place<'p>,
    all: BTreeSet<&'p str>,
}

impl<'p> Paths<'p> {
    fn of(place: &'p Place<'p>) -> Self {
        Self { place, all: place.below.iter().filter(|one| one.is_file()).map(|one| &*one.rel).collect() }
    }

    fn first(&self, start: &str) -> Option<&'p str> {
        self.all
            .range::<str, _>((Bound::Included(start), Bound::Unbounded))
            .next()
            .copied()
            .filter(|path| path.starts_with(start))
    }

    /// Whether a path begins so.
    fn has(&self, start: &str) -> bool {
        self.first(start).is_some()
    }

    /// Whether a path begins and ends so.
    fn has_kind(&self, start: &str, end: &str) -> bool {
        self.all.iter().any(|path| path.starts_with(start) && path.ends_with(end))
    }

    /// Whether a word stands in the file at a path.
    fn says(&self, rel: &str, word: &str) -> bool {
        let root = &self.place.root;
        let path = if root.is_empty() { rel.to_owned() } else { format!("{root}/{rel}") };
        let text = look_into(self.place.tree, &path).unwrap_or_default();
        text.windows(word.len()).any(|part| part == word.as_bytes())
    }
}

/// Told by what came with it, or else by the base mesh: what is missing says nothing of data for another one.
fn version_of_makehuman1(paths: &Paths<'_>, layer: &Layer) -> Option<&'static str> {
    if paths.has("targets/bodyshapes/") || paths.has("modifiers/bodyshapes_") {
        return Some("1.3");
    }
    let is_mesh = |file: &&FileFacts| file.kind_in(Application::Makehuman1) == Kind::BaseMesh;
    let mesh = layer.files.values().find(is_mesh).and_then(FileFacts::mesh);
    let has_all = || ["targets/", "modifiers/"].iter().all(|rel| paths.has(rel));
    match mesh.map_or((0, 0), |mesh| (mesh.positions.len(), mesh.uvs.len())) {
        (15340, _) => Some("alpha 6"),
        (18528, _) => Some("alpha 7"),
        (19158, 21333) if paths.has("costumes/") || paths.has("mhx/") => Some("alpha 8"),
        (19158, 21333) => Some("1.0"),
        (19158, 21334) if paths.says("VERSION", "{") || is_of_2020(paths) => Some("1.2"),
        (19158, 21334) if has_all() && !paths.has("targets.npz") => Some("1.1"),
        (19158, 21334) => None,
        // Of another mesh nobody knows.
        _ if !paths.has_kind("rigs/", ".mhskel")
            && let Some(old) = version_without_skeletons(paths) =>
        {
            Some(old)
        }
        // One folder may be gone; all of what came with 1.3 is not. In an archive nobody looks for names.
        _ if has_all() || paths.has("targets.npz") && paths.has("modifiers/") => Some("1.2"),
        _ => None,
    }
}

/// Told by the folders that went.
fn version_without_skeletons(paths: &Paths<'_>) -> Option<&'static str> {
    let has_any = |starts: &[&str]| starts.iter().any(|start| paths.has(start));
    match paths.has("modifiers/") {
        true => paths.has_kind("rigs/", ".json").then_some("1.0"),
        false if has_any(&["costumes/", "vertexgroups/"]) => Some("alpha 8"),
        false if has_any(&["cages/", "hairstyles/", "landmarks/"]) => Some("alpha 7"),
        false => has_any(&["templates/", "hairs/"]).then_some("alpha 6"),
    }
}

/// Whether the headers of its targets are those of the autumn of 2020.
fn is_of_2020(paths: &Paths<'_>) -> bool {
    paths.first("targets/").is_some_and(|rel| paths.says(rel, "september 2020"))
}

/// Each change to what it loads left a sign.
fn version_of_makehuman2(paths: &Paths<'_>) -> Option<&'static str> {
    if paths.has("props/") || paths.has("base/fantasy/") {
        return Some("2026-08-20");
    }
    let settings = || paths.all.iter().filter(|rel| rel.starts_with("base/") && rel.ends_with("/base.json"));
    let any = |word: &str| settings().any(|rel| paths.says(rel, word));
    let is_old =
        ["\"standardnumverts\"", "MakeHuman Community"].iter().any(|word| paths.says("makehuman2_version.json", word))
            || paths.has("base/cube/")
            || paths.has("base/spider/");
    match is_old {
        _ if settings().next().is_none() || any("\"numverts\"") => None,
        true if any("\"equipment\"") => Some("2025"),
        true => Some("2024"),
        false => None,
    }
}

/// The walk cycles went with the newest version; what came before that dates the others.
fn version_of_mpfb(paths: &Paths<'_>) -> Option<&'static str> {
    let rig = |name: &str| paths.has(&format!("rigs/standard/rig.{name}.json"));
    match paths.has("walkcycles/") {
        false => None,
        true if paths.has("expressions/") => Some("2.0.16"),
        true if rig("mixamo_unity") || rig("openpose") => Some("2.0.14"),
        true if paths.has("uv_layers/") => Some("2.0.10"),
        true => Some("2.0.5"),
    }
}
