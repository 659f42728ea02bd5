//! The layers of `MakeHuman` 1 with its body, what that wears, and its poses
//! (`docs/loaders/makehuman1/folders.md#libraries-and-their-places`).

use std::collections::BTreeSet;

use super::expressions::{FaceFrames, expressions};
use super::models::{self, SavedModel, models};
use super::modifiers::Modifiers;
use super::rigs::rigs;
use super::targets::Targets;
use super::{Asset, compiled, surfaces};
use crate::cubes::{Strays, strays_of};
use crate::extent::implausible;
use crate::{
    Body, BodyWeights, Doubt, FileFacts, Gaps, Layer, Layers, ReferenceKind, References, Rig,
    Surface, Target, WeightsUse, Worn,
};
use mhlint_diag::Application;
use mhlint_discover::{Kind, library_of};
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::mhclo;
use mhlint_formats::obj::Mesh;
use mhlint_formats::packed::asset::Packed;
use mhlint_source::parent;

/// Whose uses of a file count here.
pub(super) const OWN: Application = Application::Makehuman1;
/// The one base mesh.
const BODY: &str = "hm08";

/// The layers of `MakeHuman` 1.
#[derive(Debug)]
pub struct View<'a> {
    /// System and user data.
    pub layers: Layers<'a>,
    /// What names a file.
    pub references: References<'a>,
    /// The base mesh, if it can be read.
    pub mesh: Option<(&'a FileFacts, &'a Mesh)>,
    /// A base mesh that the default rig is not made for: nothing else is measured against it.
    pub foreign_mesh: Option<(&'a FileFacts, ForeignSign)>,
    /// The skeletons of all layers.
    rigs: Vec<Rig<'a>>,
    /// The groups of the body that are shown.
    shown: BTreeSet<String>,
    /// What the body can wear.
    pub(crate) worn: Vec<Worn<'a>>,
    /// The materials.
    pub(crate) surfaces: Vec<Surface<'a>>,
    /// The targets that the program finds.
    pub targets: Targets<'a>,
    /// What its sliders move.
    pub modifiers: Modifiers<'a>,
    /// Saved characters, of all layers.
    pub models: Vec<SavedModel<'a>>,
    /// What expressions are made of.
    pub face: FaceFrames<'a>,
}

/// What shows that the base mesh is not the one that the other data are for.
#[derive(Debug, Clone, Copy)]
pub enum ForeignSign {
    /// The default rig and its weights both name vertices up to this one, which it does not have.
    Short(i64),
    /// Its vertices have other numbers.
    Order(Strays),
}

/// What names of groups begin with that are not shown
/// (`docs/loaders/makehuman1/base-mesh.md#numbers-of-hm08`).
pub const HIDDEN: [&str; 2] = ["joint-", "helper-"];

/// Whether files of this kind are checked so far.
pub const fn is_checked(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::BaseMesh
            | Kind::PackedBaseMesh
            | Kind::Target
            | Kind::ModifierFile
            | Kind::ModifierTexts
            | Kind::ModifierSliders
            | Kind::ModifierMapping
            | Kind::Language
            | Kind::Skeleton
            | Kind::Weights
            | Kind::Clothes
            | Kind::Material
            | Kind::AssetMesh
            | Kind::AssetWeights
            | Kind::Motion
            | Kind::MotionMeta
            | Kind::Pose
            | Kind::FaceUnits
            | Kind::Model
            | Kind::ShaderSource
            | Kind::UvMap
            | Kind::Scene
            | Kind::ProgramSettings
            | Kind::Packed
            | Kind::TargetsNpz
            | Kind::PictureList
            | Kind::LibraryCache
            | Kind::Image
    )
}

impl<'a> View<'a> {
    /// Connects layers.
    pub fn connect(layers: Layers<'a>) -> Self {
        let rigs = rigs(layers);
        let worn = worn(layers);
        let (mut references, surfaces) = surfaces::read(layers, &worn);
        references.extend(rigs.iter().filter_map(|rig| rig.weights.clone()));
        references.extend(
            worn.iter()
                .flat_map(|worn| worn.references.iter().flatten())
                .cloned(),
        );
        let models = models(layers);
        references.extend(models::references(layers, &models, &worn));
        let mesh = mesh(layers);
        let rig = rigs.iter().find(|rig| rig.is_default);
        let foreign_mesh = mesh
            .zip(rig)
            .and_then(|((file, mesh), rig)| Some((file, foreign_sign(mesh, rig)?)));
        let mut targets = Targets::of(layers);
        let modifiers = Modifiers::of(layers, &targets);
        if targets.are_archived() && modifiers.has_no_macro() {
            targets.is_foreign = true;
            // Which targets there should be nobody can tell.
            targets.is_packed = true;
        }
        let groups = mesh
            .iter()
            .flat_map(|(_, mesh)| &mesh.groups)
            .map(|group| &group.name);
        Self {
            layers,
            references: References::new(references),
            shown: groups.filter(|name| shows(name)).cloned().collect(),
            mesh,
            foreign_mesh,
            rigs,
            worn,
            surfaces,
            modifiers,
            targets,
            models,
            face: FaceFrames::of(layers),
        }
    }

    /// The targets of the checked layer that the program finds.
    fn own_targets(&self) -> Vec<Target<'a>> {
        let custom = self
            .targets
            .custom
            .iter()
            .map(|one| custom_target(one.file));
        let shipped = self.targets.shipped.iter().enumerate();
        // What only the archive has is no file of its own.
        let shipped = shipped.filter(|(_, one)| one.file.kind_in(OWN) == Kind::Target);
        let shipped = shipped.map(|(place, one)| self.shipped(place, one.file));
        custom
            .chain(shipped)
            .filter(|target| self.layers.is_checked(target.file))
            .collect()
    }

    fn shipped<'v>(&self, place: usize, file: &'v FileFacts) -> Target<'v> {
        let used_as = self.modifiers.uses.get(&place).copied();
        let is_unused = used_as.is_none() && self.modifiers.is_whole() && !self.targets.is_packed;
        Target {
            file,
            folder: parent(&file.rel),
            used_as,
            is_unused,
            packed_in: None,
        }
    }

    /// The paths of the weights that skeletons name; `None` where this cannot be known, because a
    /// skeleton cannot be read, or names a file that leads nowhere: either may mean any weights.
    fn named_weights(&self) -> Option<BTreeSet<&str>> {
        let is_clear = self.rigs.iter().all(|rig| {
            rig.skeleton()
                .is_some_and(|one| !one.weights_file_misshapen)
        });
        self.base_rig().filter(|_| is_clear)?;
        let named = self.rigs.iter().filter_map(|rig| rig.weights.as_ref());
        named.map(|one| Some(one.meant()?.path.as_str())).collect()
    }

    /// What is known of a target of the checked layer.
    pub(crate) fn target<'v>(&'v self, file: &'v FileFacts) -> Target<'v> {
        let place = self
            .targets
            .place(&file.rel)
            .filter(|_| self.layers.checks_system());
        match place {
            Some(place) => self.shipped(place, file),
            // An archive that does not have it hides it.
            None if self.layers.checks_system() && self.targets.are_archived() => Target {
                used_as: None,
                is_unused: true,
                ..custom_target(file)
            },
            None => custom_target(file),
        }
    }

    /// The name of the base mesh, if there is one.
    pub fn body_name(&self) -> Option<&'a str> {
        self.mesh.and_then(|(file, _)| file.base_in(OWN))
    }

    /// How much of what its modifiers need the data lack.
    pub(crate) fn gaps(&self) -> Gaps<'_> {
        let parts = || self.modifiers.all.iter().flat_map(|one| one.parts.iter());
        let missing = parts()
            .filter(|part| part.targets.is_empty())
            .map(|part| part.group.as_str());
        Gaps {
            named: parts().count(),
            missing: missing.collect(),
        }
    }

    /// The body, also where its mesh is not at hand.
    pub(crate) fn body<'v>(&'v self, view: &'v crate::View<'v>) -> Body<'v> {
        let mut body = Body::new(BODY, view, self.own_targets());
        body.mesh = self.mesh.filter(|_| self.foreign_mesh.is_none());
        body.obj = self.mesh;
        body.visible_groups = self.mesh.map(|_| &self.shown);
        body.rigs = &self.rigs;
        body.doubt = self
            .foreign_mesh
            .map(|_| Doubt::Foreign)
            .or_else(|| implausible(&body).map(|_| Doubt::Misplaced));
        body.worn = &self.worn;
        // On a mesh that stops the program nobody counts vertices.
        let is_sound = self.mesh.is_none_or(|(_, mesh)| mesh.is_sound());
        let weights = view
            .files()
            .filter(|file| is_sound && file.kind == Kind::Weights);
        let named = self.named_weights();
        body.weights = weights
            .map(|file| body_weights(file, named.as_ref()))
            .collect();
        body.add_worn_weights(view.files().filter(|file| file.kind == Kind::AssetWeights));
        body.is_open = self.layers.system.is_none();
        let motions = view.files().filter(|file| file.kind == Kind::Motion);
        body.motions = motions
            .filter_map(|file| Some((file, file.motion()?)))
            .collect();
        body.poses = expressions(self.layers);
        body.pose_units = self.face.files(self.layers);
        body
    }

    /// The skeletons of all layers, strongest first.
    pub fn rigs(&self) -> &[Rig<'a>] {
        &self.rigs
    }

    /// The skeleton that poses the body.
    pub fn base_rig(&self) -> Option<&Rig<'a>> {
        self.rigs.iter().find(|rig| rig.is_default)
    }

    /// What is worn and listed, of all layers, strongest first.
    pub fn assets(&self) -> impl Iterator<Item = Asset<'a>> {
        self.worn.iter().filter_map(Asset::of)
    }

    /// What the body can wear, of all layers.
    pub fn worn(&self) -> &[Worn<'a>] {
        &self.worn
    }

    /// The materials of all layers.
    pub fn surfaces(&self) -> &[Surface<'a>] {
        &self.surfaces
    }
}

/// What shows that a mesh is not the one that the default rig is for. Of one file alone it is the
/// file that is at fault.
fn foreign_sign(mesh: &Mesh, rig: &Rig<'_>) -> Option<ForeignSign> {
    let skeleton = rig.skeleton()?;
    let named = skeleton
        .joints
        .iter()
        .filter_map(|joint| joint.vertices.as_ref())
        .flatten();
    let joints = named.copied().max();
    let weighted = rig
        .weights()
        .into_iter()
        .flat_map(|weights| &weights.bones)
        .flat_map(|bone| &bone.pairs)
        .map(|pair| pair.vertex)
        .max();
    let last = i64::try_from(mesh.facts.vertices).ok()? - 1;
    match joints.min(weighted).filter(|lower| *lower > last) {
        Some(_) if mesh.is_sound() => joints.max(weighted).map(ForeignSign::Short),
        _ => strays_of(mesh, &skeleton.joints).map(ForeignSign::Order),
    }
}

/// Weights of a skeleton, named by one or not.
fn body_weights<'v>(file: &'v FileFacts, named: Option<&BTreeSet<&str>>) -> BodyWeights<'v> {
    let is_used = named.is_none_or(|named| named.contains(file.path.as_str()));
    let used = if is_used || file.is_loose {
        WeightsUse::Applied
    } else {
        WeightsUse::Unread
    };
    BodyWeights {
        file,
        name: Some(file.rel.strip_prefix("rigs/").unwrap_or(&file.rel)),
        used,
    }
}

/// One of the user, which has a slider of its own.
fn custom_target(file: &FileFacts) -> Target<'_> {
    let used_as = Some(ReferenceKind::Incr);
    Target {
        file,
        folder: parent(&file.rel),
        used_as,
        is_unused: false,
        packed_in: None,
    }
}

/// What the body can wear, of all layers.
pub fn worn(layers: Layers<'_>) -> Vec<Worn<'_>> {
    let worn = |layer| {
        let listed = Worn::all(layer, OWN).filter(|(file, _)| library_of(&file.rel).is_some());
        let of = move |(file, base)| Worn::of(layer, file, base, &mhclo::makehuman1::READER, false);
        listed.map(move |one| {
            let worn = Worn {
                drops_bytes: true,
                ..of(one)
            }
            .beside_system(layers);
            let binary = layer.file(&format!(
                "{}/{}.mhpxy",
                parent(&worn.file.rel),
                worn.file.stem()
            ));
            let worn = Worn { binary, ..worn };
            Worn {
                packed_mesh: packed_mesh(layers, &worn),
                ..worn
            }
        })
    };
    let lone = |layer| {
        compiled::lone(layers, layer).map(move |worn| {
            let worn = worn.beside_system(layers);
            Worn {
                packed_mesh: packed_mesh(layers, &worn),
                ..worn
            }
        })
    };
    layers
        .strongest_first()
        .flat_map(|layer| worn(layer).chain(lone(layer)))
        .collect()
}

/// The mesh that the program reads in place of an OBJ: the archive beside it, if that is sound.
fn packed_mesh<'a>(layers: Layers<'a>, worn: &Worn<'a>) -> Option<(&'a FileFacts, &'a AssetMesh)> {
    let (file, mesh) = beside_mesh(layers, worn)?;
    let asked = compiled::asked_faces(worn);
    let holds = mesh
        .kept_faces
        .is_none_or(|kept| asked.iter().any(|asked| kept.holds(*asked)));
    holds.then_some((file, mesh))
}

/// The archive of the mesh that something worn names, also where it has too little room for that.
pub(super) fn beside_mesh<'a>(
    layers: Layers<'a>,
    worn: &Worn<'a>,
) -> Option<(&'a FileFacts, &'a AssetMesh)> {
    let reference = worn.reference(ReferenceKind::AssetMesh)?;
    layers
        .strongest_first()
        .find_map(|layer| mesh_archive(layer, &reference.rel))
}

/// The archive beside an OBJ, if it can be loaded.
pub fn mesh_archive<'a>(layer: &'a Layer, rel: &str) -> Option<(&'a FileFacts, &'a AssetMesh)> {
    let file = layer.file(&format!("{}.npz", rel.rsplit_once('.')?.0))?;
    match file.packed()? {
        Packed::Mesh(Ok(mesh)) if mesh.is_sound() => Some((file, mesh)),
        _ => None,
    }
}

/// The base mesh, which only the system has; in releases packed alone.
pub fn mesh(layers: Layers<'_>) -> Option<(&FileFacts, &Mesh)> {
    let files = || {
        layers
            .system
            .into_iter()
            .flat_map(|layer| layer.files.values())
    };
    let of_kind = |kind| files().find(move |file| file.kind_in(OWN) == kind);
    let file = of_kind(Kind::BaseMesh).or_else(|| of_kind(Kind::PackedBaseMesh))?;
    Some((file, file.mesh()?))
}

/// Whether a group of the base mesh is shown.
pub fn shows(group: &str) -> bool {
    !HIDDEN.iter().any(|start| group.starts_with(start))
}
