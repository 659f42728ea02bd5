//! Pictures that materials name, and where `MakeHuman` 2 looks for them
//! (`docs/loaders/makehuman2/materials.md#texture-search`).

use std::collections::{BTreeMap, BTreeSet};

use super::{OWN, surfaces};
use crate::path::{is_absolute, resolve};
use crate::{
    FileFacts, Layer, Layers, PictureFolders, Reference, ReferenceKind, Resolution, Surface,
    Wearer, Worn,
};
use mhlint_diag::Place;
use mhlint_discover::{Kind, material_of};
use mhlint_formats::mhmat::Texture;
use mhlint_source::{normalized, parent};

/// The pictures of all materials that the application opens, by base mesh, and what becomes of the
/// materials.
pub(super) fn read<'a>(
    layers: Layers<'a>,
    worn: &[Worn<'a>],
    of_models: &[Reference<'a>],
) -> (BTreeMap<&'a str, Vec<Reference<'a>>>, Vec<Surface<'a>>) {
    let mut by_base: BTreeMap<&str, Vec<Reference<'_>>> = BTreeMap::new();
    let mut surfaces = Vec::new();
    let assets: Vec<_> = layers
        .strongest_first()
        .map(|layer| Assets::of(layer, worn))
        .collect();
    let chosen = of_models
        .iter()
        .filter(|one| one.kind == ReferenceKind::ModelMaterial);
    let chosen: BTreeSet<&str> = chosen
        .filter_map(Reference::found)
        .map(|file| file.path.as_str())
        .collect();
    for layer in layers.strongest_first() {
        for file in layer.files.values().filter(|file| is_material(file)) {
            let search = file
                .base_in(OWN)
                .and_then(|base| Search::of(layers, layer, file, base));
            let is_opened = |search: &Search<'_>| {
                chosen.contains(file.path.as_str()) || search.is_opened(&assets)
            };
            let Some(search) = search.filter(is_opened) else {
                continue;
            };
            let Some(material) = file.material() else {
                continue;
            };
            let references: Vec<_> = material
                .textures
                .iter()
                .map(|texture| search.reference(texture))
                .collect();
            surfaces.push(surfaces::surface(
                layers,
                file,
                material,
                search.wearer(&assets),
                &references,
            ));
            by_base
                .entry(search.base)
                .or_default()
                .extend(in_use(references));
        }
    }
    (by_base, surfaces)
}

/// The last line of a keyword with a picture wins: what stands above it counts for nothing. A name
/// that leads out of the data is another matter: where a file is there, the application takes it.
fn in_use(all: Vec<Reference<'_>>) -> impl Iterator<Item = Reference<'_>> {
    let meant = all
        .iter()
        .enumerate()
        .filter(|(_, one)| one.meant().is_some());
    let last: BTreeMap<&str, usize> = meant.map(|(line, one)| (one.owner, line)).collect();
    all.into_iter().enumerate().filter_map(move |(line, one)| {
        let is_taken = matches!(one.resolution, Resolution::Found(_) | Resolution::Escapes);
        (is_taken || last.get(one.owner).is_none_or(|last| line >= *last)).then_some(one)
    })
}

fn is_material(file: &FileFacts) -> bool {
    file.kind_in(OWN) == Kind::Material
}

/// What can be worn of a layer.
struct Assets<'a> {
    layer: &'a Layer,
    /// Folders of assets.
    folders: BTreeSet<&'a str>,
    /// Folders with an asset in them that has no material of its own.
    with_bare: BTreeSet<&'a str>,
    /// Paths of the materials that they name.
    named: BTreeSet<&'a str>,
}

impl<'a> Assets<'a> {
    fn of(layer: &'a Layer, worn: &[Worn<'a>]) -> Self {
        let is_here = |worn: &&Worn<'_>| {
            layer
                .file(&worn.file.rel)
                .is_some_and(|own| std::ptr::eq(own, worn.file))
        };
        let folders: BTreeSet<&str> = worn
            .iter()
            .filter(is_here)
            .map(|worn| parent(&worn.file.rel))
            .collect();
        let bare = folders
            .iter()
            .filter(|asset| !layer.below(asset).any(is_material));
        // A topology wears the skin.
        let has_own = |worn: &&Worn<'a>| is_here(worn) && !worn.is_topology();
        let references = worn
            .iter()
            .filter(has_own)
            .flat_map(|worn| worn.references.iter().flatten());
        let materials = references.filter(|one| one.kind == ReferenceKind::AssetMaterial);
        let named = materials
            .filter_map(Reference::found)
            .map(|file| file.rel.as_str())
            .collect();
        Self {
            layer,
            with_bare: bare.map(|asset| parent(asset)).collect(),
            folders,
            named,
        }
    }
}

/// Whether system data that is not at hand could have a part of the base. Without an answer nobody
/// has the base.
pub(super) fn is_open(layers: Layers<'_>, base: &str) -> Option<bool> {
    let folder = format!("base/{base}");
    let has = |layer: &Layer, name: &str| layer.file(&format!("{folder}/{name}")).is_some();
    let has_mesh = |layer: &Layer| has(layer, "base.obj") || has(layer, "base.mhbin");
    // One of both alone may lie over the base of a system.
    if layers
        .strongest_first()
        .any(|layer| has(layer, "base.json") && has_mesh(layer))
    {
        return Some(false);
    }
    if layers.system.is_none() || layers.is_one_root() {
        return Some(true);
    }
    let is_there = layers
        .strongest_first()
        .any(|layer| layer.below(&folder).next().is_some());
    // A loose asset may be for a base of somebody else.
    if is_there {
        Some(false)
    } else {
        layers.checked.is_loose.then_some(true)
    }
}

/// A material with all that is asked for its pictures.
struct Search<'a> {
    file: &'a FileFacts,
    base: &'a str,
    layer: &'a Layer,
    /// Where it is looked for.
    folders: PictureFolders<'a>,
    /// Layers with a folder for all assets of this sort.
    shared: Vec<&'a Layer>,
    /// Whether system data that is not at hand could have the picture.
    is_open: bool,
}

impl<'a> Search<'a> {
    fn of(
        layers: Layers<'a>,
        layer: &'a Layer,
        file: &'a FileFacts,
        base: &'a str,
    ) -> Option<Self> {
        let folders = folders(file, base)?;
        let is_open = is_open(layers, base)?;
        let shared = layers.system.into_iter().chain(layers.user).collect();
        Some(Self {
            file,
            base,
            layer,
            folders,
            shared,
            is_open,
        })
    }

    /// What is worn has the materials below its folder. If there are none it has those of the
    /// folder `materials` beside it, eyes those of the system and of the user.
    fn is_opened(&self, assets: &[Assets<'_>]) -> bool {
        let sort = self.folders.sort;
        let is_eye = sort == "eyes";
        let offers = |assets: &Assets<'_>| {
            let is_own = std::ptr::eq(assets.layer, self.layer);
            is_own && self.is_below(&assets.folders) || (is_own || is_eye) && self.is_beside(assets)
        };
        sort == "skins"
            || is_eye && self.is_open
            || self.is_named(assets)
            || assets.iter().any(offers)
    }

    fn is_named(&self, assets: &[Assets<'_>]) -> bool {
        let is_own = |assets: &&Assets<'_>| std::ptr::eq(assets.layer, self.layer);
        assets
            .iter()
            .filter(is_own)
            .any(|assets| assets.named.contains(self.file.rel.as_str()))
    }

    fn wearer(&self, assets: &[Assets<'_>]) -> Wearer {
        match self.folders.sort {
            "skins" => Wearer::Skin,
            _ if self.is_named(assets) => Wearer::Asset,
            _ => Wearer::Choice,
        }
    }

    fn is_below(&self, folders: &BTreeSet<&str>) -> bool {
        let above = std::iter::successors(Some(parent(&self.file.rel)), |path| Some(parent(path)));
        above
            .take_while(|path| !path.is_empty())
            .any(|folder| folders.contains(folder))
    }

    fn is_beside(&self, assets: &Assets<'_>) -> bool {
        let all = &self.folders.all;
        self.file.rel.starts_with(&format!("{all}/materials/"))
            && assets.with_bare.contains(all.as_str())
    }

    fn reference(&self, texture: &'a Texture) -> Reference<'a> {
        let (rel, resolution) = self.find(&texture.word);
        Reference {
            kind: ReferenceKind::Texture,
            base: self.base,
            from: self.file,
            place: Place::Span(texture.span.clone()),
            text: &texture.word,
            owner: texture.keyword,
            folder_at_fault: None,
            rel,
            resolution,
        }
    }

    /// As the application finds it. A name with `\` may miss places, on any system, that it had
    /// with `/`.
    fn find(&self, word: &str) -> (String, Resolution<'a>) {
        let (rel, resolution) = self.nearest(word);
        if !matches!(resolution, Resolution::Backslash(None)) {
            return (rel, resolution);
        }
        match self.nearest(&word.replace('\\', "/")) {
            (slashed, Resolution::Found(file) | Resolution::CaseOnly(file)) => {
                (slashed, Resolution::Backslash(Some(file)))
            }
            (slashed, Resolution::NeedsSystem) => (slashed, Resolution::NeedsSystem),
            _ => (rel, resolution),
        }
    }

    /// The first place with the picture; without one, the place that comes nearest to it.
    fn nearest(&self, word: &str) -> (String, Resolution<'a>) {
        let mut tried: Vec<(String, Resolution<'a>)> = Vec::new();
        for (layer, rel, text) in self.places(word) {
            let resolution = resolve(&[layer], text, &rel);
            let ends = matches!(resolution, Resolution::Found(_) | Resolution::Escapes);
            tried.push((normalized(&rel).unwrap_or(rel), resolution));
            if ends {
                break;
            }
        }
        // Outside of the data there may be anything: what comes behind may never be reached.
        let escape = tried.pop_if(|(_, resolution)| matches!(resolution, Resolution::Escapes));
        let nearest = || {
            tried
                .into_iter()
                .min_by_key(|(_, resolution)| resolution.distance())
        };
        let (rel, resolution) = escape
            .or_else(nearest)
            .unwrap_or((String::new(), Resolution::Missing));
        let resolution = resolution.in_pack(&[self.layer], self.file, word);
        // A name without a folder is that of a picture beside the loose asset.
        let is_own = self.layer.is_loose && !word.contains('/');
        let is_open = self.is_open && !is_own && matches!(resolution, Resolution::Missing);
        (
            rel,
            if is_open {
                Resolution::NeedsSystem
            } else {
                resolution
            },
        )
    }

    /// Where the picture is looked for, in order, and what of the name is left there.
    fn places<'w>(&self, word: &'w str) -> Vec<(&'a Layer, String, &'w str)> {
        let PictureFolders {
            own,
            above,
            sort,
            all,
        } = &self.folders;
        // What begins with a slash is not put behind the folder.
        let below = word
            .split_once('/')
            .map(|(_, below)| below)
            .filter(|below| !is_absolute(below));
        let mut places = vec![(self.layer, format!("{own}/{word}"), word)];
        places.extend(above.map(|above| (self.layer, format!("{above}/{word}"), word)));
        places.extend(below.map(|below| (self.layer, format!("{own}/{below}"), below)));
        let shared = below.filter(|_| word.starts_with(sort)).unwrap_or(word);
        places.extend(
            self.shared
                .iter()
                .map(|layer| (*layer, format!("{all}/{shared}"), shared)),
        );
        places
    }
}

/// Where the pictures of a material for a base mesh are looked for.
pub(crate) fn folders<'a>(material: &'a FileFacts, base: &str) -> Option<PictureFolders<'a>> {
    let (own, sort) = (parent(&material.rel), material_of(&material.rel)?.folder);
    let above = own.ends_with("materials").then(|| parent(own));
    Some(PictureFolders {
        own,
        above,
        sort,
        all: format!("{sort}/{base}"),
    })
}
