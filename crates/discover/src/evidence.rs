//! Evidence for and against a data root belonging to an application
//! (`docs/loaders/versions.md#whose-data-a-folder-is`).

use std::collections::{BTreeMap, BTreeSet};

use super::layout::{LIBRARIES, WORN};
use super::listing::{Listing, at};
use mhlint_diag::Application;
use mhlint_source::{extension, folder_and_name};

/// Evidence that a data root belongs to an application.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Evidence {
    /// Files and folders that only this application has, or only few others have.
    pub signs: Vec<String>,
    /// Whether the data root can belong to no other application.
    pub is_certain: bool,
    /// Whether it is certain because of files beside the data folder.
    pub is_certain_beside: bool,
    /// How many signs there are, including those that `signs` leaves out.
    pub(super) found: usize,
    /// How many of the signs also occur in users' folders of another application.
    pub(super) alike: usize,
}

/// Signs that occur in users' folders of two applications.
const OF_USERS: [&str; 6] = [
    "custom/",
    "proxymeshes/",
    META,
    DIRECTLY_IN_LIBRARIES,
    "targets/custom/",
    "packs/",
];
/// The words at the end of signs that lie beside the data folder.
const BESIDE: &str = " beside it";
const META: &str = ".meta";
const DIRECTLY_IN_LIBRARIES: &str = "assets directly in their libraries";

/// A data root and the listing that it lies in.
struct Root<'l> {
    listing: &'l Listing<'l>,
    path: &'l str,
    /// The paths of the files in it, relative to the data root.
    files: Vec<&'l str>,
}

/// The evidence that the data root at a path belongs to an application.
pub fn evidence(listing: &Listing<'_>, path: &str, application: Application) -> Evidence {
    let start = if path.is_empty() { 0 } else { path.len() + 1 };
    let files = listing
        .below(path)
        .filter_map(|file| file.get(start..))
        .collect();
    let root = Root {
        listing,
        path,
        files,
    };
    let (certain, others) = match application {
        Application::Makehuman2 => of_makehuman2(&root),
        Application::Makehuman1 => of_makehuman1(&root),
        Application::Mpfb => of_mpfb(&root),
    };
    let is_certain = !certain.is_empty();
    let is_certain_beside = certain.iter().any(|sign| sign.ends_with(BESIDE));
    let mut signs = certain;
    let is_said = |sign: &&str| certain_starts(&signs, sign);
    let others: Vec<&str> = others.into_iter().filter(|sign| !is_said(sign)).collect();
    signs.extend(others.into_iter().map(str::to_owned));
    let (found, alike) = (
        signs.len(),
        signs
            .iter()
            .filter(|sign| OF_USERS.contains(&sign.as_str()))
            .count(),
    );
    signs.truncate(SIGNS);
    Evidence {
        signs,
        is_certain,
        is_certain_beside,
        found,
        alike,
    }
}

/// The evidence against the data root at a path belonging to an application, in a few words.
pub fn lacks(listing: &Listing<'_>, path: &str, application: Application) -> String {
    let start = if path.is_empty() { 0 } else { path.len() + 1 };
    let mut files = listing.below(path).filter_map(|file| file.get(start..));
    match application {
        Application::Makehuman2
            if files.any(|file| matches!(parts(file).as_slice(), ["base", _, "base.json"])) =>
        {
            "no targets for its base mesh".to_owned()
        }
        Application::Makehuman2 => "no base.json".to_owned(),
        Application::Makehuman1 if has_base_folders(&mut files) => {
            "its libraries have a folder for each base mesh".to_owned()
        }
        Application::Makehuman1 => missing(
            listing,
            path,
            &["modifiers", "custom", "3dobjs", "proxymeshes"],
        ),
        Application::Mpfb => missing(
            listing,
            path,
            &["mesh_metadata", "packs", "node_trees", "ink_layers"],
        ),
    }
}

/// A text that names the first two of these folders that do not exist.
fn missing(listing: &Listing<'_>, path: &str, folders: &[&str]) -> String {
    let missing = folders
        .iter()
        .filter(|folder| listing.below(&at(path, folder)).next().is_none());
    let missing: Vec<String> = missing
        .take(2)
        .map(|folder| format!("no {folder}/"))
        .collect();
    if missing.is_empty() {
        "more of another application".to_owned()
    } else {
        missing.join(", ")
    }
}

/// At most this many signs are named.
const SIGNS: usize = 5;

/// Whether the signs that were named before include a path in the folder `sign`.
fn certain_starts(signs: &[String], sign: &str) -> bool {
    signs.iter().any(|known| known.starts_with(sign))
}

fn parts(path: &str) -> Vec<&str> {
    path.split('/').collect()
}

fn has_base_folders<'f>(files: &mut impl Iterator<Item = &'f str>) -> bool {
    files.any(|file| match parts(file).as_slice() {
        [library, "hm08" | "mh2bot", ..] => WORN.contains(library),
        _ => false,
    })
}

impl Root<'_> {
    fn has(&self, rel: &str) -> bool {
        self.files.binary_search(&rel).is_ok()
    }

    fn has_folder(&self, rel: &str) -> bool {
        let below = format!("{rel}/");
        self.files
            .get(self.files.partition_point(|file| *file < below.as_str()))
            .is_some_and(|file| file.starts_with(&below))
    }

    fn any(&self, is_wanted: impl Fn(&[&str]) -> bool) -> bool {
        self.files.iter().any(|file| is_wanted(&parts(file)))
    }

    /// The folders, of those given, that exist; spelt as given, with `/` at their ends.
    fn folders(&self, names: &[&'static str]) -> Vec<&'static str> {
        names
            .iter()
            .copied()
            .filter(|name| self.has_folder(name.trim_end_matches('/')))
            .collect()
    }

    /// Whether `folder` beside the data folder has a file whose name is wanted.
    fn has_beside(&self, folder: &str, is_wanted: impl Fn(&str) -> bool) -> bool {
        let (above, name) = folder_and_name(self.path);
        name == "data"
            && self
                .listing
                .below(&at(above, folder))
                .any(|file| is_wanted(folder_and_name(file).1))
    }
}

type Signs = (Vec<String>, Vec<&'static str>);

fn of_makehuman2(root: &Root<'_>) -> Signs {
    let mut certain = Vec::new();
    let settings = root
        .files
        .iter()
        .find(|file| matches!(parts(file).as_slice(), ["base", _, "base.json"]));
    certain.extend(settings.map(|file| (*file).to_owned()));
    let is_database =
        |file: &&&str| matches!(parts(file).as_slice(), ["dbcache", _, "repository.db"]);
    certain.extend(
        root.files
            .iter()
            .find(is_database)
            .map(|file| (*file).to_owned()),
    );
    certain.extend(
        base_of_many_libraries(root).map(|base| format!("a folder {base}/ in each library")),
    );
    let mut others = Vec::new();
    others.extend(
        root.has("makehuman2_version.json")
            .then_some("makehuman2_version.json"),
    );
    others.extend(root.folders(&[
        "target/",
        "contarget/",
        "dbcache/",
        "downloads/",
        "exports/",
        "grab/",
    ]));
    (certain, others)
}

/// The name of a folder that at least three libraries contain: it must be that of a base mesh.
fn base_of_many_libraries(root: &Root<'_>) -> Option<String> {
    let mut libraries: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for file in &root.files {
        if let [library, base, _, ..] = parts(file).as_slice()
            && (WORN.contains(library)
                || LIBRARIES.contains(library)
                || matches!(*library, "target" | "proxy" | "models"))
        {
            libraries.entry(base).or_default().insert(library);
        }
    }
    let (base, _) = libraries
        .into_iter()
        .find(|(base, libraries)| libraries.len() >= 3 && *base != "materials")?;
    Some(base.to_owned())
}

fn of_makehuman1(root: &Root<'_>) -> Signs {
    let mut certain = Vec::new();
    // MPFB has `3dobjs/base.obj` and this folder as well, but its targets are packed.
    let is_target = |file: &[&str]| match file {
        ["targets", "macrodetails", .., name] => extension(name) == "target",
        _ => false,
    };
    if root.has("3dobjs/base.obj") && root.any(is_target) {
        certain.push("3dobjs/base.obj with targets/macrodetails/".to_owned());
    }
    if root.has("targets.npz") && root.has("images.list") {
        certain.push("targets.npz with images.list".to_owned());
    }
    if root.has_beside("cache", |name| name.ends_with("_filecache.mhc")) {
        certain.push(format!("cache/*_filecache.mhc{BESIDE}"));
    }
    if root.has_beside("models", |name| extension(name).eq_ignore_ascii_case("mhm")) {
        certain.push(format!("models/*.mhm{BESIDE}"));
    }
    let mut others = Vec::new();
    others.extend(root.has("3dobjs/base.obj").then_some("3dobjs/base.obj"));
    others.extend(
        root.any(|file| matches!(file, ["modifiers", name] if name.ends_with("_modifiers.json")))
            .then_some("modifiers/"),
    );
    others.extend(
        root.has("rigs/default.mhskel")
            .then_some("rigs/default.mhskel"),
    );
    others.extend(root.folders(&["custom/", "proxymeshes/", "poseunits/", "litspheres/"]));
    others.extend(
        root.any(|file| file.last().is_some_and(|name| extension(name) == "mhpxy"))
            .then_some(".mhpxy"),
    );
    others.extend(
        root.any(|file| file.last().is_some_and(|name| extension(name) == "meta"))
            .then_some(META),
    );
    let is_asset = |file: &[&str]| match file {
        [library, _, name] => WORN.contains(library) && extension(name) == "mhclo",
        _ => false,
    };
    others.extend(root.any(is_asset).then_some(DIRECTLY_IN_LIBRARIES));
    (certain, others)
}

fn of_mpfb(root: &Root<'_>) -> Signs {
    let mut certain = Vec::new();
    certain.extend(
        root.has("mesh_metadata/hm08_config.json")
            .then(|| "mesh_metadata/hm08_config.json".to_owned()),
    );
    if root.has_beside("config", |name| {
        name.starts_with("human.") && extension(name) == "json"
    }) {
        certain.push(format!("config/human.*.json{BESIDE}"));
    }
    let says = |file: &str, word: &str| root.listing.says(&at(root.path, file), &[word]);
    let of = |folder: &'static str| {
        root.files
            .iter()
            .filter(move |file| parts(file).len() == 2 && file.starts_with(folder))
    };
    let rig =
        of("rigs/").find(|file| extension(file) == "json" && says(file, "\"identifying_bones\""));
    certain.extend(rig.map(|file| format!("{file} with `identifying_bones`")));
    let pack = of("packs/").find(|file| extension(file) == "json" && says(file, "\"license\""));
    certain.extend(pack.map(|file| (*file).to_owned()));
    let mut others = Vec::new();
    others.extend(
        root.has("targets/target.json")
            .then_some("targets/target.json"),
    );
    others.extend(root.folders(&[
        "mesh_metadata/",
        "node_trees/",
        "rigs/standard/",
        "ink_layers/",
        "uv_layers/",
        "packs/",
    ]));
    others.extend(
        root.any(|file| file.last().is_some_and(|name| name.ends_with(".target.gz")))
            .then_some(".target.gz"),
    );
    others.extend(root.folders(&["targets/custom/"]));
    (certain, others)
}
