//! What the lists of assets show, and by what it is known
//! (`docs/loaders/makehuman2/libraries.md#identity`).
//!
//! An asset is known by its name and its uuid, whatever its category; of several that are known by
//! the same, all but one are lost. What the binary of an asset says of itself is looked at where
//! there is no text.

use std::collections::{BTreeMap, BTreeSet};

use super::OWN;
use crate::{FileFacts, Layer, Layers};
use mhlint_discover::{Kind, listed_in};
use mhlint_formats::mhclo::Value;
use mhlint_formats::packed::asset::Packed;

/// An asset that is listed.
#[derive(Debug)]
pub struct Asset<'a> {
    /// Its file.
    pub file: &'a FileFacts,
    /// The base mesh that it is for.
    pub base: &'a str,
    /// The folder at the top that it lies in.
    pub category: &'a str,
    /// Its name in the list.
    pub name: String,
    /// What else it is known by.
    pub uuid: String,
    /// Its tags as they are written.
    pub tags: Vec<String>,
}

/// All assets of all layers, strongest first, by base.
#[derive(Debug, Default)]
pub struct Library<'a> {
    assets: Vec<Asset<'a>>,
    /// Numbers by base and name.
    by_name: BTreeMap<(&'a str, String), Vec<usize>>,
    /// Numbers of the first ones that are worn, by base and name.
    worn: BTreeMap<(&'a str, String), usize>,
    /// Numbers of the first ones by base, name and uuid.
    by_identity: BTreeMap<(&'a str, String, String), usize>,
    /// What is worn and lies where no list looks, or has a suffix that none takes, by name.
    unlisted: BTreeMap<String, &'a FileFacts>,
}

impl<'a> Library<'a> {
    /// The assets of layers with these base meshes.
    pub(super) fn of(layers: Layers<'a>, bases: &BTreeSet<&str>) -> Self {
        let mut library = Self::default();
        for layer in layers.strongest_first() {
            library
                .assets
                .extend(layer.files.values().filter_map(|file| asset(layer, file)));
            library.unlisted.extend(
                layer
                    .files
                    .values()
                    .filter_map(|file| unlisted(file, bases)),
            );
        }
        library.assets.sort_by_key(|asset| asset.base);
        for (number, asset) in library.assets.iter().enumerate() {
            let name = (asset.base, asset.name.clone());
            let identity = (asset.base, asset.name.clone(), asset.uuid.clone());
            library.by_identity.entry(identity).or_insert(number);
            if asset.is_worn() {
                library.worn.entry(name.clone()).or_insert(number);
            }
            library.by_name.entry(name).or_default().push(number);
        }
        library
    }

    /// The assets of a base.
    pub fn of_base(&self, base: &str) -> &[Asset<'a>] {
        let start = self.assets.partition_point(|asset| asset.base < base);
        let end = self.assets.partition_point(|asset| asset.base <= base);
        self.assets.get(start..end).unwrap_or_default()
    }

    /// The assets of a base by name.
    pub fn named(&self, base: &'a str, name: &str) -> impl Iterator<Item = &Asset<'a>> {
        let numbers = self
            .by_name
            .get(&(base, name.to_owned()))
            .into_iter()
            .flatten();
        numbers.filter_map(|number| self.assets.get(*number))
    }

    /// What a model gets that asks for a name and a uuid: the asset that is known by both, or else
    /// one of the name.
    pub fn worn(&self, base: &'a str, name: &str, uuid: &str) -> Option<&Asset<'a>> {
        let identity = (base, name.to_owned(), uuid.to_owned());
        let both = self.by_identity.get(&identity);
        let number = both.or_else(|| self.worn.get(&(base, name.to_owned())))?;
        self.assets.get(*number)
    }

    /// What is worn under a name but not listed: why that is has a finding of its own.
    pub fn unlisted(&self, name: &str) -> Option<&'a FileFacts> {
        self.unlisted.get(name).copied()
    }

    /// Assets of a base that are known by the same, each group strongest first.
    pub fn clashes(&self, base: &str) -> Vec<Vec<&Asset<'a>>> {
        let mut known: BTreeMap<String, Vec<&Asset<'a>>> = BTreeMap::new();
        for asset in self.of_base(base) {
            known
                .entry(format!("{}{}", asset.name, asset.uuid))
                .or_default()
                .push(asset);
        }
        known
            .into_values()
            .filter(|assets| assets.len() > 1)
            .collect()
    }

    /// The base meshes that assets are for.
    pub fn bases(&self) -> BTreeSet<&'a str> {
        self.assets.iter().map(|asset| asset.base).collect()
    }
}

impl Asset<'_> {
    /// Whether a body wears it.
    pub fn is_worn(&self) -> bool {
        matches!(self.file.kind_in(OWN), Kind::Clothes | Kind::Packed)
    }

    /// What people call such an asset.
    pub fn noun(&self) -> &'static str {
        match self.category {
            "hair" => "hair",
            "proxy" => "topology",
            "rigs" => "skeleton",
            "poses" => "pose",
            "expressions" => "expression",
            "models" => "model",
            "skins" => "skin",
            _ => "asset",
        }
    }
}

fn asset<'a>(layer: &'a Layer, file: &'a FileFacts) -> Option<Asset<'a>> {
    let category = listed_in(&file.rel)?;
    let (name, uuid, tags) = known_by(layer, file)?;
    Some(Asset {
        file,
        base: file.base_in(OWN)?,
        category,
        name,
        uuid,
        tags,
    })
}

/// What is worn and not listed, with its name; that of one with another suffix is not read.
fn unlisted<'a>(file: &'a FileFacts, bases: &BTreeSet<&str>) -> Option<(String, &'a FileFacts)> {
    let has_base = file.base_in(OWN).is_some_and(|base| bases.contains(base));
    if has_base && listed_in(&file.rel).is_some() {
        return None;
    }
    let has_suffix = |suffix: &str| file.file_name().to_lowercase().contains(suffix);
    match file.clothes() {
        Some(clothes) => Some((clothes.scanned.name.as_ref()?.text.to_string(), file)),
        None if has_suffix(".mhclo") || has_suffix(".proxy") => {
            let name = file.file_name();
            Some((name.split('.').next().unwrap_or(name).to_owned(), file))
        }
        None => None,
    }
}

/// Name, uuid and tags; nothing of a file that could not be read.
fn known_by(layer: &Layer, file: &FileFacts) -> Option<(String, String, Vec<String>)> {
    let stem = || file.stem().to_owned();
    // Without a name in it, a JSON is listed under its whole path.
    let path = || {
        file.path
            .rsplit_once('.')
            .map_or(file.path.as_str(), |(path, _)| path)
            .to_owned()
    };
    Some(match file.kind_in(OWN) {
        Kind::Skeleton => {
            let name = file.skeleton()?.name.clone().unwrap_or_else(path);
            (name.clone(), format!("skel_{name}"), Vec::new())
        }
        Kind::Pose => {
            let pose = file.pose()?;
            let name = pose.name.clone().unwrap_or_else(path);
            (name.clone(), format!("pose_{name}"), pose.tags.clone())
        }
        Kind::Motion => {
            let meta = file
                .rel
                .strip_suffix("bvh")
                .and_then(|rel| layer.file(&format!("{rel}meta")));
            let meta = meta.and_then(FileFacts::meta);
            let name = meta
                .and_then(|meta| meta.name.as_ref())
                .map_or_else(stem, |name| name.listed.to_string());
            (
                name,
                format!("bvh_{}", file.stem()),
                meta.map(|meta| meta.tags.clone()).unwrap_or_default(),
            )
        }
        Kind::Material => (stem(), format!("skin_{}", file.stem()), Vec::new()),
        Kind::Model => {
            let model = file.model()?;
            let name = model
                .name
                .as_deref()
                .filter(|name| !name.is_empty())
                .map_or_else(stem, str::to_owned);
            (
                name,
                stem(),
                model.tags.iter().map(ToString::to_string).collect(),
            )
        }
        Kind::Clothes => return of_clothes(file),
        Kind::Packed => return of_packed(layer, file),
        _ => return None,
    })
}

/// An asset that is nothing but its binary.
fn of_packed(layer: &Layer, file: &FileFacts) -> Option<(String, String, Vec<String>)> {
    let Packed::Asset(asset) = file.packed()? else {
        return None;
    };
    let [name, uuid, ..] = &asset.texts;
    layer
        .text_of_archive(&file.rel)
        .is_none()
        .then(|| (name.to_string(), uuid.to_string(), Vec::new()))
}

fn of_clothes(file: &FileFacts) -> Option<(String, String, Vec<String>)> {
    let scanned = &file.clothes()?.scanned;
    let text = |value: &Option<Value>| value.as_ref().map(|value| value.text.to_string());
    let tags = scanned
        .tags
        .iter()
        .map(|tag| tag.text.to_lowercase())
        .collect();
    Some((
        text(&scanned.name).unwrap_or_default(),
        text(&scanned.uuid).unwrap_or_else(|| "0".to_owned()),
        tags,
    ))
}
