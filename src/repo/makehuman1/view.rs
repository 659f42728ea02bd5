//! The layers of `MakeHuman` 1 with its body, what that wears, and its poses (formats/makehuman1.md §2, §10 to §12, §16).

use std::collections::BTreeSet;

use super::{Asset, surfaces};
use crate::diag::Application;
use crate::discover::{Kind, library_of};
use crate::formats::obj::Mesh;
use crate::repo::{Body, FileFacts, Layers, References, Rig, Surface, Target, Worn, parent};

/// Whose uses of a file count here.
pub(super) const OWN: Application = Application::Makehuman1;
/// The skeleton that poses the body, which only the system has.
const POSED: &str = "rigs/default.mhskel";
/// The one base mesh.
const BODY: &str = "hm08";

/// The layers of `MakeHuman` 1.
#[derive(Debug)]
pub(crate) struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// What names a file.
    pub references: References<'a>,
    /// The base mesh, if it can be read.
    pub(crate) mesh: Option<(&'a FileFacts, &'a Mesh)>,
    /// The skeleton of the body, without its weights.
    rigs: Vec<Rig<'a>>,
    /// The groups of the body that are shown.
    shown: BTreeSet<String>,
    /// What the body can wear.
    pub(in crate::repo) worn: Vec<Worn<'a>>,
    /// The materials.
    pub(in crate::repo) surfaces: Vec<Surface<'a>>,
}

/// What names of groups begin with that are not shown (§1).
pub(crate) const HIDDEN: [&str; 2] = ["joint-", "helper-"];

/// Whether files of this kind are checked so far: those of libraries, and the body that wears them.
pub(crate) const fn is_of_library(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::BaseMesh
            | Kind::Clothes
            | Kind::Material
            | Kind::AssetMesh
            | Kind::AssetWeights
            | Kind::Motion
            | Kind::MotionMeta
            | Kind::ShaderSource
            | Kind::UvMap
            | Kind::Image
    )
}

impl<'a> View<'a> {
    /// Connects layers.
    pub(crate) fn connect(layers: Layers<'a>) -> Self {
        let system = || layers.system.into_iter().flat_map(|layer| layer.files.values());
        let rig = system().find(|file| file.rel == POSED);
        let rigs = rig.map(|file| Rig { file, weights: None, is_default: true, is_found: true });
        let worn = worn(layers);
        let (mut references, surfaces) = surfaces::read(layers, &worn);
        references.extend(worn.iter().flat_map(|worn| worn.references.iter().flatten()).cloned());
        let mesh = mesh(layers);
        let groups = mesh.iter().flat_map(|(_, mesh)| &mesh.groups).map(|group| &group.name);
        Self {
            layers,
            references: References::new(references),
            shown: groups.filter(|name| shows(name)).cloned().collect(),
            mesh,
            rigs: rigs.into_iter().collect(),
            worn,
            surfaces,
        }
    }

    /// The name of the base mesh, if there is one.
    pub(crate) fn body_name(&self) -> Option<&'a str> {
        self.mesh.and_then(|(file, _)| file.base_in(OWN))
    }

    /// The body, also where its mesh is not at hand. Of its own weights, and of its targets, nothing is told so far.
    pub(in crate::repo) fn body<'v>(&'v self, view: &'v crate::repo::View<'v>) -> Body<'v> {
        let mut body = Body::new(BODY, view, Vec::new());
        body.mesh = self.mesh;
        body.obj = self.mesh;
        body.visible_groups = self.mesh.map(|_| &self.shown);
        body.rigs = &self.rigs;
        body.worn = &self.worn;
        body.add_worn_weights(view.files().filter(|file| file.kind == Kind::AssetWeights));
        body.is_open = self.layers.system.is_none();
        let listed = view.files().filter(|file| file.kind == Kind::Motion && library_of(&file.rel).is_some());
        body.motions = listed.filter_map(|file| Some((file, file.motion()?))).collect();
        body
    }

    /// What is worn and listed, of all layers, strongest first.
    pub(crate) fn assets(&self) -> impl Iterator<Item = Asset<'a>> {
        self.worn.iter().filter_map(Asset::of)
    }

    /// What the body can wear, of all layers.
    pub(crate) fn worn(&self) -> &[Worn<'a>] {
        &self.worn
    }

    /// The materials of all layers.
    pub(crate) fn surfaces(&self) -> &[Surface<'a>] {
        &self.surfaces
    }
}

/// What the body can wear, of all layers.
pub(crate) fn worn(layers: Layers<'_>) -> Vec<Worn<'_>> {
    let worn = |layer| {
        let listed = Worn::all(layer, OWN).filter(|(file, _)| library_of(&file.rel).is_some());
        let of = move |(file, base)| Worn::of(layer, file, base, |name| !name.has_colon, false);
        listed.map(move |one| Worn { drops_bytes: true, ..of(one) }.beside_system(layers))
    };
    layers.strongest_first().flat_map(worn).collect()
}

/// The base mesh, which only the system has.
pub(crate) fn mesh(layers: Layers<'_>) -> Option<(&FileFacts, &Mesh)> {
    let files = layers.system.into_iter().flat_map(|layer| layer.files.values());
    let file = files.into_iter().find(|file| file.kind_in(OWN) == Kind::BaseMesh)?;
    Some((file, file.mesh()?))
}

/// Whether a group of the base mesh is shown.
pub(crate) fn shows(group: &str) -> bool {
    !HIDDEN.iter().any(|start| group.starts_with(start))
}

/// What is known of a target of the checked layer.
pub(in crate::repo) fn target(file: &FileFacts) -> Target<'_> {
    Target { file, folder: parent(&file.rel), used_as: None, is_unused: false, packed_in: None }
}
