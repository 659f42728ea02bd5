//! Gives assets outside of data roots the paths that they would have in a user's data root.
//!
//! The folder that an asset lies in is taken for the folder of the asset in its library, with
//! everything below it. A file that the asset names and that lies outside of that folder keeps its
//! place relative to the folder.

use std::collections::{BTreeMap, BTreeSet};

use super::{Candidate, Kind, Layout, extension, meant_extension};
use mhlint_source::{Entry, EntryKind, Tree, folder_and_name, folders_above, normalized};

/// The base mesh that a loose file is for: `Some(None)` if it is not known which, `None` if the
/// file is no asset but merely has the extension of one.
pub type Binding = Option<Option<String>>;

/// What a run knows about the files of a tree besides their paths.
pub struct Known<'k> {
    /// The path of the folder that is the top of the tree.
    pub top: &'k str,
    /// Whether a file may be used.
    pub is_asked: &'k dyn Fn(&Entry) -> bool,
    /// Whether only files directly in the top folder, and the files that they name, are used.
    pub is_shallow: bool,
    /// The base mesh for a file that has the name of an asset. It also gets the names of the
    /// folders above the file, the nearest first.
    pub bind: &'k dyn Fn(&Entry, &[&str]) -> Binding,
    /// The library that the content of an asset speaks for, where no folder above it has the name
    /// of a library.
    pub list: &'k dyn Fn(&Entry) -> Option<&'static str>,
    /// The names of other files that a file contains.
    pub names: &'k dyn Fn(&Entry) -> Vec<String>,
}

/// The loose files of a tree at the paths that they would have for an application.
pub struct Loose<'t> {
    /// The files, sorted by their supposed paths.
    pub files: Vec<Candidate<'t>>,
    /// For each file the files that it names, as paths in the tree.
    named: BTreeMap<&'t str, BTreeSet<&'t str>>,
}

impl<'t> Loose<'t> {
    /// The files that belong to those at these paths: those that they name, those that these name
    /// in turn, and those that lie beside one of them under the same name with another extension.
    pub fn belonging_to(&self, paths: impl Iterator<Item = &'t str>) -> BTreeSet<&'t str> {
        let mut all: BTreeSet<&str> = paths.collect();
        let mut open: Vec<&str> = all.iter().copied().collect();
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

/// Whether a file is an asset by itself, whatever folder it lies in. Materials are left out, since
/// they may be a part of another asset.
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

/// Gives the loose files of a tree the paths that they would have in a data root with this layout.
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
    // Other assets go first: a material that belongs to one of them is no skin.
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
/// Extension of the packed copy that MakeHuman 1 makes of clothes and proxies.
const ARCHIVE: &str = "mhpxy";

/// An asset that an application would list, and the supposed path of its folder.
struct Asset<'t> {
    entry: &'t Entry,
    home: String,
}

/// The loose files, some of which have got their supposed path.
struct Placing<'t, 'k> {
    tree: &'t Tree,
    layout: &'static Layout,
    known: &'k Known<'k>,
    files: Vec<&'t Entry>,
    /// The supposed folders of assets.
    homes: BTreeSet<String>,
    /// For each supposed folder how many assets wanted it: the number in the name of the last one.
    taken_homes: BTreeMap<String, usize>,
    /// Paths in the tree of the files that have got a supposed path.
    placed: BTreeSet<&'t str>,
    /// The files by their supposed paths.
    at: BTreeMap<String, &'t Entry>,
    named: BTreeMap<&'t str, BTreeSet<&'t str>>,
}

impl<'t, 'k> Placing<'t, 'k> {
    /// Gives paths to the assets with the wanted extensions, to the files in their folders, and to
    /// the files that they name.
    fn place_assets(&mut self, is_wanted: impl Fn(&str) -> bool) {
        let assets = self.assets(is_wanted);
        let mut open = Vec::new();
        for asset in assets.values().flatten() {
            let (_, name) = folder_and_name(&asset.entry.path);
            open.extend(self.put(asset.entry, format!("{}/{name}", asset.home)));
        }
        let mut by_stem = BTreeMap::new();
        for asset in assets.values().flatten() {
            by_stem.entry(stem(&asset.entry.path)).or_insert(asset);
        }
        for entry in self.files.clone() {
            if !self.placed.contains(entry.path.as_str())
                && let Some(rel) = self.place_beside(&assets, &by_stem, entry)
            {
                open.extend(self.put(entry, rel));
            }
        }
        self.follow(open);
    }

    /// The assets with the wanted extensions, by the folder that they lie in.
    fn assets(&mut self, is_wanted: impl Fn(&str) -> bool) -> BTreeMap<&'t str, Vec<Asset<'t>>> {
        let mut assets: BTreeMap<&str, Vec<Asset<'_>>> = BTreeMap::new();
        let mut homes: BTreeMap<(&str, String), String> = BTreeMap::new();
        let with_worn = self.folders_with_worn();
        for entry in self.files.clone() {
            let (folder, _) = folder_and_name(&entry.path);
            let is_open = is_wanted(meant_extension(&entry.path))
                && !self.placed.contains(entry.path.as_str());
            let is_near = !self.known.is_shallow || folder.is_empty();
            // A material in the folder of clothes, or in a folder below, belongs to these and is no
            // skin, even if nothing is known about the clothes.
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

    /// Whether a file is the packed copy of a text file beside it: then the text file is the asset.
    fn has_text(&self, entry: &Entry) -> bool {
        let stem = entry.path.strip_suffix(ARCHIVE);
        stem.is_some_and(|stem| {
            ["mhclo", "proxy"]
                .iter()
                .any(|text| self.tree.entry(&format!("{stem}{text}")).is_some())
        })
    }

    /// The folders that contain clothes or proxies.
    fn folders_with_worn(&self) -> BTreeSet<&'t str> {
        let is_worn =
            |entry: &&&Entry| matches!(meant_extension(&entry.path), "mhclo" | "proxy" | ARCHIVE);
        let worn = self.files.iter().filter(is_worn);
        worn.map(|entry| folder_and_name(&entry.path).0).collect()
    }

    /// The names of a folder and of the folders above it, the nearest first.
    fn above<'p>(&self, folder: &'p str) -> Vec<&'p str>
    where
        'k: 'p,
    {
        // The last two names of the path of the tree count as well: the folder around the tree may
        // be called after a library.
        let top = self.known.top.rsplit('/').take(2);
        folder
            .rsplit('/')
            .chain(top)
            .filter(|name| !name.is_empty())
            .collect()
    }

    /// A supposed folder for an asset, called like the folder that it lies in, with a number if
    /// another asset has that folder already. In the library `flat` of the layout the first asset
    /// lies in the folder of the library itself.
    fn new_home(&mut self, library: &str, above: &str, folder: &str) -> String {
        if library == self.layout.flat && self.homes.insert(above.to_owned()) {
            return above.to_owned();
        }
        let own = if folder.is_empty() {
            self.known.top
        } else {
            folder
        };
        // The point at the start is left out: applications treat hidden folders in another way.
        let (_, name) = folder_and_name(own.trim_end_matches('/'));
        let name = Some(name.trim_start_matches('.'))
            .filter(|name| !name.is_empty())
            .unwrap_or("asset");
        let first = format!("{above}/{name}");
        // The number of the last asset with this name is kept, so that taken names are not tried
        // again.
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

    /// The supposed path of a file that no application lists: in the folder of the asset that has
    /// the same name, otherwise in that of the first asset of the nearest folder with assets.
    fn place_beside(
        &self,
        assets: &BTreeMap<&str, Vec<Asset<'t>>>,
        by_stem: &BTreeMap<&str, &Asset<'t>>,
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
        let partner = by_stem.get(stem(&entry.path)).copied();
        let asset = partner.or(all.first())?;
        let rest = entry.path.strip_prefix(nearest)?.trim_start_matches('/');
        Some(format!("{}/{rest}", asset.home))
    }

    /// Gives a file the supposed path `rel`, unless another file has that path. Returns the file if
    /// it got the path, so that the files it names can be placed next.
    fn put(&mut self, entry: &'t Entry, rel: String) -> Option<(&'t Entry, String)> {
        if self.at.contains_key(&rel) {
            return None;
        }
        self.placed.insert(&entry.path);
        self.at.insert(rel.clone(), entry);
        Some((entry, rel))
    }

    /// Gives paths to the files that these files name, and so on. A name is resolved from the
    /// supposed path of the file that contains it.
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

    /// Gives paths to files that are checked without an asset: targets, and weights without a
    /// skeleton.
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

    /// Returns `rel`, or `rel` with a number behind its folder if another file has that path: files
    /// from several folders are put into one, and may have equal names.
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

/// The name of the base mesh where nothing says which it is. No application has a base mesh of this
/// name.
pub const UNKNOWN_BASE: &str = "(loose)";

/// Whether a file below the folder of an asset may be a part of the asset, by its extension; other
/// files belong to other programs.
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

/// Whether a file is a JSON, of any program.
fn is_json(name: &str) -> bool {
    Kind::by_extension(name) == Kind::Json
}
