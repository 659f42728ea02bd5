//! All bases over the layers, and what names what in them.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::base::base_names;
use super::known::KnownNames;
use super::references::collect;
use super::usage::Usage;
use super::{
    Base, Library, OWN, SavedModel, models, poses, target_folder, textures, weights, worn,
};
use crate::extent::implausible;
use crate::{
    Body, Doubt, FileFacts, Landmarks, Layers, Reference, References, Surface, Target, Worn,
};
use mhlint_diag::grouped;
use mhlint_discover::{Kind, listed_in};
use mhlint_formats::base_json::BaseJson;
use mhlint_formats::selection_filter::SelectionFilter;
use mhlint_source::parent;

/// `MakeHuman` 2's data, connected.
#[derive(Debug)]
pub struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// The base meshes of all layers, by name.
    pub bases: Vec<Base<'a>>,
    /// The numbers of these by their names in lower case; of several the first.
    bases_in_lower_case: BTreeMap<String, usize>,
    /// Everything that names a file, and what it leads to.
    pub references: References<'a>,
    /// What bodies can wear, sorted by base.
    pub(crate) worn: Vec<Worn<'a>>,
    /// Numbers of these by printed path.
    worn_by_path: BTreeMap<&'a str, usize>,
    /// What the lists of assets show.
    pub library: Library<'a>,
    /// The characters of each base.
    models: BTreeMap<&'a str, Vec<SavedModel<'a>>>,
    /// The characters that wear an asset, by printed path of its files.
    wearers: BTreeMap<&'a str, Vec<SavedModel<'a>>>,
    /// The materials that it opens.
    pub(crate) surfaces: Vec<Surface<'a>>,
    usage: Usage<'a>,
    /// By base; made when a fix asks for them.
    pub(super) known_names: OnceLock<BTreeMap<String, KnownNames>>,
}

impl<'a> View<'a> {
    /// Connects layers.
    pub fn connect(layers: Layers<'a>) -> Self {
        let bases: Vec<Base<'a>> = base_names(layers)
            .into_iter()
            .map(|name| Base::resolve(name, layers))
            .collect();
        let worn = worn(layers, None);
        let library = Library::of(layers, &bases.iter().map(|base| base.name).collect());
        let (mut all_models, mut wearers, mut named) =
            (BTreeMap::new(), BTreeMap::new(), Vec::new());
        for base in &bases {
            let own = models::models(layers, base);
            let is_open = textures::is_open(layers, base.name).unwrap_or(true);
            let references = models::references(layers, base, &own, &library, is_open);
            wearers.extend(models::wearers(
                base.name,
                &own,
                &library,
                of_body(&worn, base.name),
                &references,
            ));
            named.extend(references);
            all_models.insert(base.name, own);
        }
        let (mut textures, surfaces) = textures::read(layers, &worn, &named);
        let of_base = |base| {
            collect(base)
                .into_iter()
                .chain(textures.remove(base.name).unwrap_or_default())
        };
        let mut references: Vec<Reference<'a>> = bases.iter().flat_map(of_base).collect();
        references.extend(named);
        // Assets for a base that no layer has.
        references.extend(textures.into_values().flatten());
        references.extend(
            worn.iter()
                .flat_map(|worn| worn.references.iter().flatten())
                .cloned(),
        );
        let references = References::new(references);
        let usage = Usage::of(layers, &bases, &references);
        let numbered = bases.iter().enumerate().rev();
        let in_lower_case = numbered.map(|(at, base)| (base.name.to_ascii_lowercase(), at));
        Self {
            layers,
            bases_in_lower_case: in_lower_case.collect(),
            bases,
            references,
            worn_by_path: worn
                .iter()
                .enumerate()
                .map(|(at, worn)| (worn.file.path.as_str(), at))
                .collect(),
            worn,
            surfaces,
            library,
            models: all_models,
            wearers,
            usage,
            known_names: OnceLock::new(),
        }
    }

    /// The base of a name.
    pub fn base(&self, name: &str) -> Option<&Base<'a>> {
        let at = self
            .bases
            .binary_search_by(|base| base.name.cmp(name))
            .ok()?;
        self.bases.get(at)
    }

    /// The first base mesh whose name differs in nothing but case.
    pub fn base_ignoring_case(&self, name: &str) -> Option<&Base<'a>> {
        let at = self.bases_in_lower_case.get(&name.to_ascii_lowercase())?;
        self.bases.get(*at)
    }

    /// References for a base.
    pub fn references_of(&self, base: &Base<'_>) -> impl Iterator<Item = &Reference<'a>> {
        self.references.of_base(base.name).iter()
    }

    /// Targets that the application reads for the base and that nothing uses: those of the folder
    /// in use, and user targets too deep to become sliders.
    pub fn unused(&self, base: &Base<'_>) -> &[&'a FileFacts] {
        self.usage.unused(base)
    }

    /// Whether the base that a mesh belongs to shows the group.
    pub(crate) fn draws(&self, mesh: &FileFacts, group: &str) -> bool {
        let base = self
            .bases
            .iter()
            .find(|base| Some(base.name) == mesh.base_in(OWN));
        base.and_then(Base::settings)
            .is_none_or(|(_, settings)| settings.shows(group))
    }

    /// Where on its body the vertices of a mesh are, if it is the mesh of a base.
    pub fn landmarks<'m>(&'m self, mesh: &FileFacts) -> Option<Landmarks<'m>> {
        let base = mesh.base_in(OWN).and_then(|name| self.base(name))?;
        base.mesh
            .filter(|(file, _)| std::ptr::eq(*file, mesh))
            .and_then(|_| base.landmarks())
    }

    /// Whether a path lies in the target folder of a user, whose JSON `MakeHuman` 2 writes itself.
    pub(crate) fn is_generated(&self, rel: &str) -> bool {
        let layers = self.layers;
        let user = layers
            .user
            .is_some_and(|user| std::ptr::eq(user, layers.checked));
        user && !layers.is_one_root() && rel.starts_with("target/")
    }

    /// Whether another file is read as the base mesh in place of what is at a path of the checked
    /// layer: an OBJ behind an archive, or an archive that is no file, which counts as none.
    pub(crate) fn is_replaced(&self, rel: &str) -> bool {
        let checked = self.layers.checked;
        let exists = |name: &str| {
            self.layers
                .first_existing(&format!("{}/{name}", parent(rel)))
                .is_some()
        };
        match checked.kind_at(rel, OWN) {
            Kind::BaseMesh => exists("base.mhbin"),
            Kind::MeshArchive => {
                checked.file(rel).is_none() && (exists("base.mhbin") || exists("base.obj"))
            }
            _ => false,
        }
    }

    /// Whether the file is the `macro.json` of a base without a macro slider.
    pub(crate) fn does_without(&self, file: &FileFacts) -> bool {
        let base = file.base_in(OWN).and_then(|name| self.base(name));
        let has_none =
            |base: &Base<'_>| !base.sliders.iter().any(|slider| slider.slider.is_macro());
        file.kind_in(OWN) == Kind::MacroJson && base.is_none_or(has_none)
    }

    /// The targets of a base in the checked layer.
    pub fn own_targets<'v>(
        &'v self,
        base: &Base<'_>,
    ) -> impl Iterator<Item = &'a FileFacts> + use<'v, 'a> {
        let folders = ["contarget", "target"].map(|folder| format!("{folder}/{}", base.name));
        let files = folders
            .into_iter()
            .flat_map(|folder| self.layers.checked.below(&folder).collect::<Vec<_>>());
        files.filter(|file| file.kind_in(OWN) == Kind::Target)
    }

    /// A body for every base, and one for the targets and weights that belong to none.
    pub(crate) fn bodies<'v>(&'v self, view: &'v crate::View<'v>) -> Vec<Body<'v>> {
        let files = view.files().filter(|file| is_of_body(file));
        let files = grouped(files.map(|file| (file.base_in(OWN).unwrap_or_default(), file)));
        let mut files: BTreeMap<_, _> = files.into_iter().collect();
        let body = |name: &'v str, files: Vec<&'v FileFacts>| {
            let of = |kind| files.iter().copied().filter(move |file| file.kind == kind);
            let base = self.base(name);
            let mut body = Body::new(
                name,
                view,
                of(Kind::Target).map(|file| self.target(file)).collect(),
            );
            if let Some(base) = base {
                fill(&mut body, base);
            }
            body.worn = self.worn_of(name);
            let others = of(Kind::Weights).filter(|_| base.is_none());
            body.add_worn_weights(others.chain(of(Kind::AssetWeights)));
            body.is_open = base.is_none_or(|base| self.is_open(base));
            body.poses = poses::poses(of(Kind::Pose));
            body.pose_units = base
                .map(|base| poses::units(self.layers, base.name).into())
                .unwrap_or_default();
            let listed = of(Kind::Motion).filter(|file| listed_in(&file.rel) == Some("poses"));
            body.motions = listed
                .filter_map(|file| Some((file, file.motion()?)))
                .collect();
            body
        };
        let mut bodies: Vec<Body<'v>> = Vec::new();
        for base in &self.bases {
            bodies.push(body(base.name, files.remove(base.name).unwrap_or_default()));
        }
        bodies.extend(files.into_iter().map(|(name, files)| body(name, files)));
        bodies
    }

    /// What the body of this name can wear.
    fn worn_of(&self, name: &str) -> &[Worn<'a>] {
        of_body(&self.worn, name)
    }

    /// The characters of a base, of all layers.
    pub fn models_of(&self, base: &Base<'_>) -> &[SavedModel<'a>] {
        self.models
            .get(base.name)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// The characters that wear the asset which the file at a printed path is, or is part of; the
    /// one that is loaded at start comes first.
    pub fn wearers(&self, path: &str) -> &[SavedModel<'a>] {
        self.wearers
            .get(path)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// The labels by which the assets of a category are chosen: the user's, or else the system's.
    pub fn filter(&self, category: &str, base: &str) -> Option<&'a SelectionFilter> {
        let rel = format!("{category}/{base}/selection_filter.json");
        let mut files = self
            .layers
            .strongest_first()
            .filter_map(|layer| layer.file(&rel));
        files.find_map(|file| file.filter().filter(|_| !file.json.falsy))
    }

    /// The files that an asset names, if it could be read.
    pub fn worn_references(&self, file: &FileFacts) -> Option<&[Reference<'a>]> {
        self.worn
            .get(*self.worn_by_path.get(file.path.as_str())?)?
            .references
            .as_deref()
    }

    /// Assets of a base that are listed and could not be read.
    pub fn worn_unread(&self, base: &str) -> impl Iterator<Item = &'a FileFacts> {
        of_body(&self.worn, base)
            .iter()
            .filter(|worn| worn.references.is_none())
            .map(|worn| worn.file)
    }

    /// Whether system data that is not at hand could have what a base lacks.
    pub fn is_open(&self, base: &Base<'_>) -> bool {
        textures::is_open(self.layers, base.name).unwrap_or(true)
    }

    /// What is known of a target of the checked layer.
    pub fn target<'v>(&'v self, file: &'v FileFacts) -> Target<'v> {
        let folder = target_folder::of(file);
        Target {
            file,
            folder,
            used_as: self.usage.of_file(file),
            is_unused: self.usage.is_unused(file),
            packed_in: self
                .layers
                .checked
                .file(&format!("{folder}/compressedtargets.npz")),
        }
    }
}

fn is_of_body(file: &FileFacts) -> bool {
    matches!(
        file.kind,
        Kind::Target
            | Kind::Weights
            | Kind::AssetWeights
            | Kind::Motion
            | Kind::Pose
            | Kind::Clothes
            | Kind::Packed
    )
}

/// What the body of this name can wear, of all that is sorted by base.
fn of_body<'w, 'a>(worn: &'w [Worn<'a>], name: &str) -> &'w [Worn<'a>] {
    let start = worn.partition_point(|worn| worn.base < name);
    let end = worn.partition_point(|worn| worn.base <= name);
    worn.get(start..end).unwrap_or_default()
}

/// What a base adds to its body.
fn fill<'v>(body: &mut Body<'v>, base: &'v Base<'_>) {
    body.mesh = base.mesh;
    body.obj = base.obj();
    let settings = base.settings().map(|(_, settings)| settings);
    body.visible_groups = settings.and_then(|settings| settings.shown.as_ref());
    let random = |settings: &'v BaseJson| {
        settings
            .random
            .as_ref()
            .map(|random| random.nonsym.as_slice())
    };
    body.one_sided_endings = settings.map(|settings| random(settings).unwrap_or_default());
    body.macros = base.macro_file();
    body.has_too_many_macros = base.has_too_many_macros();
    body.rigs = &base.rigs;
    let is_foreign = base.foreign_mesh.is_some();
    body.doubt = if is_foreign {
        Some(Doubt::Foreign)
    } else {
        implausible(body).map(|_| Doubt::Misplaced)
    };
    body.weights = weights::weights(base);
}
