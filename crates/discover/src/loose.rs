//! Assets outside of data roots, put where a user's data root would have them.
//!
//! The folder with an asset becomes its folder in the library, with everything below it. What the
//! asset names outside of that folder keeps its place beside it.

use std::collections::{BTreeMap, BTreeSet};

use super::{Candidate, Kind, Layout, extension, meant_extension};
use mhlint_source::{Entry, EntryKind, Tree, folder_and_name, folders_above, normalized};

/// The base mesh that a loose file is for, if that is known; `None` for a file that is none of
/// ours.
pub type Binding = Option<Option<String>>;

/// What a run knows of the files of a tree besides their paths.
pub struct Known<'k> {
    /// The folder that is the top of the tree, with those above it.
    pub top: &'k str,
    /// Whether a file may be looked at.
    pub is_asked: &'k dyn Fn(&Entry) -> bool,
    /// Whether only the files at the top and what these name are to be looked at.
    pub is_shallow: bool,
    /// Asked for files with the name of an asset, with the names of the folders above it, the
    /// nearest first.
    pub bind: &'k dyn Fn(&Entry, &[&str]) -> Binding,
    /// The list that the content of an asset speaks for, where no folder does.
    pub list: &'k dyn Fn(&Entry) -> Option<&'static str>,
    /// The names of files in a text.
    pub names: &'k dyn Fn(&Entry) -> Vec<String>,
}

/// The loose files of a tree as an application would have them.
pub struct Loose<'t> {
    /// Sorted by their supposed paths.
    pub files: Vec<Candidate<'t>>,
    /// The files that a file names, by their paths in the tree.
    named: BTreeMap<&'t str, BTreeSet<&'t str>>,
}

impl<'t> Loose<'t> {
    /// What belongs to the file at a path: what it names, what that names, and what lies beside
    /// each under the same name.
    pub fn belonging_to(&self, path: &'t str) -> BTreeSet<&'t str> {
        let mut all = BTreeSet::from([path]);
        let mut open = vec![path];
        while let Some(path) = open.pop() {
            let named = self.named.get(path).into_iter().flatten().copied();
            open.extend(named.filter(|named| all.insert(named)));
        }
        let stems: BTreeSet<&str> = all.iter().map(|path| stem(path)).collect();
        let beside = self.files.iter().map(|file| file.entry.path.as_str());
        all.extend(beside.filter(|path| !is_asset(path) && stems.contains(stem(path))));
        all
    }
}

/// Whether a file is an asset of its own wherever it lies. A material may be a part of one.
fn is_asset(path: &str) -> bool {
    matches!(
        meant_extension(path),
        "mhclo" | "proxy" | "mhskel" | "mhpose" | "bvh" | "mhm" | "target"
    )
}

/// A path without its extension.
fn stem(path: &str) -> &str {
    path.strip_suffix(extension(path)).unwrap_or(path)
}

/// Puts the loose files of a tree where `layout` has them.
pub fn loose<'t>(tree: &'t Tree, layout: &'static Layout, known: &Known<'_>) -> Loose<'t> {
    let files = tree
        .entries()
        .iter()
        .filter(|entry| entry.kind == EntryKind::File && (known.is_asked)(entry));
    let mut placing = Placing {
        tree,
        layout,
        known,
        files: files.collect(),
        homes: BTreeSet::new(),
        taken_homes: BTreeMap::new(),
        placed: BTreeSet::new(),
        at: BTreeMap::new(),
        named: BTreeMap::new(),
    };
    // What is a material of something is no skin.
    placing.place_assets(|extension| extension != MATERIAL);
    placing.place_assets(|extension| extension == MATERIAL);
    placing.place_single();
    let (named, at) = (placing.named, placing.at);
    Loose {
        files: at
            .into_iter()
            .map(|(rel, entry)| Candidate::loose(entry, rel, layout))
            .collect(),
        named,
    }
}

/// Extension of materials.
const MATERIAL: &str = "mhmat";
/// Extension of what MakeHuman 1 packs of something worn.
const ARCHIVE: &str = "mhpxy";

/// An asset that a list shows, and where its folder is put.
struct Asset<'t> {
    entry: &'t Entry,
    home: String,
}

/// Loose files on their way.
struct Placing<'t, 'k> {
    tree: &'t Tree,
    layout: &'static Layout,
    known: &'k Known<'k>,
    files: Vec<&'t Entry>,
    /// Supposed folders of assets.
    homes: BTreeSet<String>,
    /// How many have a name in common, or have taken it.
    taken_homes: BTreeMap<String, usize>,
    /// Paths of the files that have a place.
    placed: BTreeSet<&'t str>,
    /// Files by their supposed paths.
    at: BTreeMap<String, &'t Entry>,
    named: BTreeMap<&'t str, BTreeSet<&'t str>>,
}

impl<'t, 'k> Placing<'t, 'k> {
    /// Places the assets with these extensions, what lies in their folders, and what they name.
    fn place_assets(&mut self, is_wanted: impl Fn(&str) -> bool) {
        let assets = self.assets(is_wanted);
        let mut open = Vec::new();
        for asset in assets.values().flatten() {
            let (_, name) = folder_and_name(&asset.entry.path);
            open.extend(self.put(asset.entry, format!("{}/{name}", asset.home)));
        }
        for entry in self.files.clone() {
            if !self.placed.contains(entry.path.as_str())
                && let Some(rel) = self.place_beside(&assets, entry)
            {
                open.extend(self.put(entry, rel));
            }
        }
        self.follow(open);
    }

    /// The assets, by the folder that they lie in.
    fn assets(&mut self, is_wanted: impl Fn(&str) -> bool) -> BTreeMap<&'t str, Vec<Asset<'t>>> {
        let mut assets: BTreeMap<&str, Vec<Asset<'_>>> = BTreeMap::new();
        let mut homes: BTreeMap<(&str, String), String> = BTreeMap::new();
        let with_worn = self.folders_with_worn();
        for entry in self.files.clone() {
            let (folder, _) = folder_and_name(&entry.path);
            let is_open = is_wanted(meant_extension(&entry.path))
                && !self.placed.contains(entry.path.as_str());
            let is_near = !self.known.is_shallow || folder.is_empty();
            // A material below something to wear is no skin, even if that is none of ours.
            let is_part = || {
                meant_extension(&entry.path) == MATERIAL
                    && folders_above(folder).any(|above| with_worn.contains(above))
            };
            if !(is_open && is_near) || is_part() || self.has_text(entry) {
                continue;
            }
            let above = self.above(folder);
            let lists: Vec<&str> = above
                .iter()
                .copied()
                .chain((self.known.list)(entry))
                .collect();
            let Some(library) = (self.layout.shelf)(meant_extension(&entry.path), &lists) else {
                continue;
            };
            let Some(base) = (self.known.bind)(entry, &above) else {
                continue;
            };
            let above = match base.filter(|_| self.layout.has_bases) {
                Some(base) => format!("{library}/{base}"),
                None if self.layout.has_bases => format!("{library}/{UNKNOWN_BASE}"),
                None => library.to_owned(),
            };
            let home = homes
                .entry((folder, above.clone()))
                .or_insert_with(|| self.new_home(library, &above, folder));
            assets.entry(folder).or_default().push(Asset {
                entry,
                home: home.clone(),
            });
        }
        assets
    }

    /// Whether it is the archive of a text beside it, which is the asset then.
    fn has_text(&self, entry: &Entry) -> bool {
        let stem = entry.path.strip_suffix(ARCHIVE);
        stem.is_some_and(|stem| {
            ["mhclo", "proxy"]
                .iter()
                .any(|text| self.tree.entry(&format!("{stem}{text}")).is_some())
        })
    }

    /// The folders with something to wear.
    fn folders_with_worn(&self) -> BTreeSet<&'t str> {
        let is_worn =
            |entry: &&&Entry| matches!(meant_extension(&entry.path), "mhclo" | "proxy" | ARCHIVE);
        let worn = self.files.iter().filter(is_worn);
        worn.map(|entry| folder_and_name(&entry.path).0).collect()
    }

    /// The names of a folder and those above it, the nearest first.
    fn above<'p>(&self, folder: &'p str) -> Vec<&'p str>
    where
        'k: 'p,
    {
        // Of what lies above the tree the folder that holds its top still says what this is.
        let top = self.known.top.rsplit('/').take(2);
        folder
            .rsplit('/')
            .chain(top)
            .filter(|name| !name.is_empty())
            .collect()
    }

    /// A folder for an asset with the name of its own, which no other asset has.
    fn new_home(&mut self, library: &str, above: &str, folder: &str) -> String {
        if library == self.layout.flat && self.homes.insert(above.to_owned()) {
            return above.to_owned();
        }
        let own = if folder.is_empty() {
            self.known.top
        } else {
            folder
        };
        // A hidden folder would be another matter.
        let (_, name) = folder_and_name(own.trim_end_matches('/'));
        let name = Some(name.trim_start_matches('.'))
            .filter(|name| !name.is_empty())
            .unwrap_or("asset");
        let first = format!("{above}/{name}");
        // Where many have one name, those that are taken are not tried again.
        let taken = self.taken_homes.entry(first.clone()).or_default();
        loop {
            *taken += 1;
            let home = if *taken == 1 {
                first.clone()
            } else {
                format!("{first}_{taken}")
            };
            if self.homes.insert(home.clone()) {
                return home;
            }
        }
    }

    /// Where a file comes to lie that no list shows: beside the asset of its name, else with the
    /// first of the nearest folder with assets.
    fn place_beside(
        &self,
        assets: &BTreeMap<&str, Vec<Asset<'t>>>,
        entry: &Entry,
    ) -> Option<String> {
        let (folder, name) = folder_and_name(&entry.path);
        let (nearest, all) =
            folders_above(folder).find_map(|folder| assets.get_key_value(folder))?;
        let is_direct = *nearest == folder;
        if is_asset(&entry.path)
            || !is_direct && (self.known.is_shallow || !is_of_asset(name))
            || is_json(name)
        {
            return None;
        }
        let is_partner = |asset: &&Asset<'_>| stem(&asset.entry.path) == stem(&entry.path);
        let asset = all.iter().find(is_partner).or(all.first())?;
        let rest = entry.path.strip_prefix(nearest)?.trim_start_matches('/');
        Some(format!("{}/{rest}", asset.home))
    }

    /// Gives a file a place, if that is free; what is there then is to be followed.
    fn put(&mut self, entry: &'t Entry, rel: String) -> Option<(&'t Entry, String)> {
        if self.at.contains_key(&rel) {
            return None;
        }
        self.placed.insert(&entry.path);
        self.at.insert(rel.clone(), entry);
        Some((entry, rel))
    }

    /// Places what these files name, each as seen from the file that names it.
    fn follow(&mut self, mut open: Vec<(&'t Entry, String)>) {
        while let Some((from, rel)) = open.pop() {
            if !matches!(
                meant_extension(&rel),
                "mhclo" | "proxy" | "mhmat" | "mhskel"
            ) {
                continue;
            }
            let ((own, _), (supposed, _)) = (folder_and_name(&from.path), folder_and_name(&rel));
            for name in (self.known.names)(from) {
                let there =
                    normalized(&format!("{own}/{name}")).and_then(|path| self.tree.entry(&path));
                let Some(to) =
                    there.filter(|to| to.kind == EntryKind::File && (self.known.is_asked)(to))
                else {
                    continue;
                };
                self.named.entry(&from.path).or_default().insert(&to.path);
                let place = normalized(&format!("{supposed}/{name}"));
                open.extend(place.and_then(|place| self.put(to, place)));
            }
        }
    }

    /// Places what is checked alone: targets, and weights without a skeleton.
    fn place_single(&mut self) {
        let mut doubles: BTreeMap<String, usize> = BTreeMap::new();
        for entry in self.files.clone() {
            let is_near = !self.known.is_shallow || !entry.path.contains('/');
            let is_open = is_near && !self.placed.contains(entry.path.as_str());
            if !is_open || (self.layout.loose_place)(&entry.path, None).is_none() {
                continue;
            }
            let above = self.above(folder_and_name(&entry.path).0);
            let Some(base) = (self.known.bind)(entry, &above) else {
                continue;
            };
            let Some(rel) = (self.layout.loose_place)(&entry.path, base.as_deref()) else {
                continue;
            };
            let rel = self.free(rel, &mut doubles);
            self.put(entry, rel);
        }
    }

    /// Folders are joined to one, and several can become the same.
    fn free(&self, rel: String, doubles: &mut BTreeMap<String, usize>) -> String {
        if !self.at.contains_key(&rel) {
            return rel;
        }
        let (folder, file) = folder_and_name(&rel);
        let number = doubles.entry(rel.clone()).or_default();
        loop {
            *number += 1;
            let other = format!("{folder}_{number}/{file}");
            if !self.at.contains_key(&other) {
                return other;
            }
        }
    }
}

/// Stands for the base mesh where nothing says which one it is; no application has one of this
/// name.
pub const UNKNOWN_BASE: &str = "(loose)";

/// Whether a file below the folder of an asset may be a part of it: what else there is belongs to
/// other programs.
fn is_of_asset(name: &str) -> bool {
    matches!(
        Kind::by_extension(name),
        Kind::Material
            | Kind::AssetMesh
            | Kind::AssetWeights
            | Kind::Image
            | Kind::UvMap
            | Kind::Packed
    )
}

/// Whether it is a JSON of whatever program.
fn is_json(name: &str) -> bool {
    Kind::by_extension(name) == Kind::Json
}
