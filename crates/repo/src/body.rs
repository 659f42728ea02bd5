//! A body as every application has it: a mesh, what moves it, and the rigs that pose it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;
use std::sync::{Arc, OnceLock};

use super::landmarks::{Landmarks, Region, Unreached};
use super::{FileFacts, Layers, Reference, ReferenceKind, View, Worn};
use mhlint_diag::Application;
use mhlint_formats::asset_mesh::AssetMesh;
use mhlint_formats::bvh::Motion;
use mhlint_formats::bvh::blender::ImportedMotion;
use mhlint_formats::macro_json::MacroFile;
use mhlint_formats::mhpose::Pose;
use mhlint_formats::mhskel::Skeleton;
use mhlint_formats::mhw::Weights;
use mhlint_formats::npz::{Archive, Member};
use mhlint_formats::obj::Mesh;
use mhlint_formats::pose_units::PoseUnits;
use mhlint_formats::unfit::NamedAt;
use mhlint_source::parent;

/// Why not everything can be told by a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doubt {
    /// The rest of the data is made for vertices with other numbers.
    Foreign,
    /// Its vertices lie elsewhere than they should: distances on it mean nothing.
    Misplaced,
}

/// A body of a view. One without a name has the files that belong to no known mesh.
#[derive(Debug)]
pub struct Body<'v> {
    /// What the application calls its mesh.
    pub name: &'v str,
    /// Where its files come from.
    pub layers: Layers<'v>,
    /// The mesh, if the application gets through it.
    pub mesh: Option<(&'v FileFacts, &'v Mesh)>,
    /// The OBJ of the mesh: the mesh itself, or what lies beside an archive to be packed anew.
    pub obj: Option<(&'v FileFacts, &'v Mesh)>,
    /// Why not everything can be told by the mesh.
    pub doubt: Option<Doubt>,
    /// Groups of the mesh that are shown, if that is said anywhere.
    pub visible_groups: Option<&'v BTreeSet<String>>,
    /// Endings of the names of targets that are meant to be one-sided. `None` where nobody can
    /// tell.
    pub one_sided_endings: Option<&'v [String]>,
    /// `macro.json` in use.
    pub macros: Option<(&'v FileFacts, &'v MacroFile)>,
    /// Whether they are more than rules compare with one another.
    pub has_too_many_macros: bool,
    /// Targets of the checked layer.
    pub targets: Vec<Target<'v>>,
    /// Targets of the checked layer for what the body wears, which are loaded by hand.
    pub part_targets: Vec<&'v FileFacts>,
    /// Skeletons with their weights.
    pub rigs: &'v [Rig<'v>],
    /// All weights of the body, and those of the checked layer for what it wears.
    pub weights: Vec<BodyWeights<'v>>,
    /// What the body can wear, of all layers.
    pub worn: &'v [Worn<'v>],
    /// Motions that the application lists for the body, those of the checked layer.
    pub motions: Vec<(&'v FileFacts, &'v Motion)>,
    /// Motions that the application imports by a less strict reader, those of the checked layer.
    pub imported_motions: Vec<(&'v FileFacts, &'v ImportedMotion)>,
    /// Whether system data that is not at hand could have what the body lacks.
    pub is_open: bool,
    /// Poses and expressions that the application lists for the body, those of the checked layer.
    pub poses: Vec<BodyPose<'v>>,
    /// Poses that name bones of rigs themselves, those of the checked layer whose rig is at hand.
    pub stored_poses: Vec<StoredBones<'v>>,
    /// What poses and expressions are made of.
    pub pose_units: Vec<PoseUnitsFile<'v>>,
    view: &'v View<'v>,
    /// Of each slider with two targets of the body these.
    pub slider_ends: Vec<[&'v FileFacts; 2]>,
    /// Numbers of the targets by printed path.
    by_path: BTreeMap<&'v str, usize>,
    /// Made when a place is asked for.
    landmarks: OnceLock<Landmarks<'v>>,
}

/// A setting at which a target is applied fully.
#[derive(Debug, Clone, PartialEq)]
pub enum Shown<'v> {
    /// Sliders as the application spells them, with their values.
    At(Vec<(String, f64)>),
    /// A combination of macro values whose sliders cannot be told.
    Combination(&'v str),
}

/// A target of a body.
#[derive(Debug)]
pub struct Target<'v> {
    /// Its file.
    pub file: &'v FileFacts,
    /// The folder that it belongs to, with all below it.
    pub folder: &'v str,
    /// How it is used; of several uses the earliest.
    pub used_as: Option<ReferenceKind>,
    /// Whether the application reads it and nothing uses it. Both are false where nobody can tell.
    pub is_unused: bool,
    /// The archive beside it, sound or not.
    pub packed_in: Option<&'v FileFacts>,
}

/// A skeleton and the weights that it names.
#[derive(Debug)]
pub struct Rig<'a> {
    /// The skeleton.
    pub file: &'a FileFacts,
    /// What it names as weights; `None` where it names none, or cannot be read.
    pub weights: Option<Reference<'a>>,
    /// Whether it is the one that the application poses the body with.
    pub is_default: bool,
    /// Whether the application finds it.
    pub is_found: bool,
}

/// A pose or an expression.
#[derive(Debug, Clone, Copy)]
pub struct BodyPose<'v> {
    /// Its file.
    pub file: &'v FileFacts,
    /// What is in it.
    pub pose: &'v Pose,
    /// Whether it is an expression.
    pub is_expression: bool,
    /// The unit of today that one of an older version becomes.
    pub renewed: fn(&str) -> Option<&'static str>,
}

/// The bones that a stored pose turns, and those of the rig that it is offered for.
#[derive(Debug)]
pub struct StoredBones<'v> {
    /// The pose.
    pub file: &'v FileFacts,
    /// The bones that it names.
    pub named: &'v [NamedAt],
    /// The rig.
    pub rig: &'v FileFacts,
    /// The bones of that.
    pub known: Arc<BTreeSet<&'v str>>,
}

/// The units of poses, or those of expressions.
#[derive(Debug)]
pub struct PoseUnitsFile<'v> {
    /// Folder of the poses that are made of them.
    pub category: &'static str,
    /// Path of the file below a data root.
    pub rel: String,
    /// Whether anything is there under that name, capitals aside.
    pub is_there: bool,
    /// The file that is read, if it could be.
    pub units: Option<(&'v FileFacts, &'v PoseUnits)>,
    /// The same where units are frames of a motion that have names alone.
    pub frames: Option<(&'v FileFacts, &'v [String])>,
    /// Their names; made when first asked for.
    pub(crate) names: OnceLock<BTreeSet<&'v str>>,
}

impl<'v> PoseUnitsFile<'v> {
    /// The file with their names, if they could be read.
    pub fn names(&self) -> Option<(&'v FileFacts, &BTreeSet<&'v str>)> {
        let of_units = self.units.map(|(file, _)| file);
        let file = of_units.or_else(|| self.frames.map(|(file, _)| file))?;
        let names = || match (self.units, self.frames) {
            (Some((_, units)), _) => units.units.iter().map(|unit| &*unit.name).collect(),
            (None, Some((_, names))) => names.iter().map(String::as_str).collect(),
            (None, None) => BTreeSet::new(),
        };
        Some((file, self.names.get_or_init(names)))
    }
}

/// Weights of a body, or of an asset that it wears.
#[derive(Debug)]
pub struct BodyWeights<'v> {
    /// Their file.
    pub file: &'v FileFacts,
    /// What a skeleton of the body has to call them; `None` where they are for another mesh than
    /// its own.
    pub name: Option<&'v str>,
    /// What becomes of them.
    pub used: WeightsUse,
}

/// What an application does with weights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WeightsUse {
    /// Something moves by them; also where nobody can tell.
    Applied,
    /// It loads them and moves nothing by them.
    Loaded,
    /// It never reads them.
    Unread,
}

impl<'a> Rig<'a> {
    /// The skeleton, if it could be read.
    pub fn skeleton(&self) -> Option<&'a Skeleton> {
        self.file.skeleton()
    }

    /// The file of the weights.
    pub fn weights_file(&self) -> Option<&'a FileFacts> {
        self.weights.as_ref()?.found()
    }

    /// The weights, if they could be read.
    pub fn weights(&self) -> Option<&'a Weights> {
        self.weights_file()?.weights()
    }

    /// The weights with their file, if they can be used.
    pub fn usable_weights(&self) -> Option<(&'a FileFacts, &'a Weights)> {
        let file = self.weights_file()?;
        Some((file, file.weights().filter(|weights| weights.has_weights)?))
    }
}

impl<'v> Body<'v> {
    /// A body with nothing but targets.
    pub(super) fn new(name: &'v str, view: &'v View<'v>, targets: Vec<Target<'v>>) -> Self {
        let by_path = targets
            .iter()
            .enumerate()
            .map(|(at, target)| (target.file.path.as_str(), at))
            .collect();
        let (mesh, obj, visible_groups, one_sided_endings, macros, rigs) =
            (None, None, None, None, None, [].as_slice());
        let (weights, worn, layers) = (Vec::new(), [].as_slice(), view.layers());
        let has_too_many_macros = false;
        Self {
            name,
            layers,
            mesh,
            obj,
            doubt: None,
            visible_groups,
            one_sided_endings,
            macros,
            has_too_many_macros,
            targets,
            part_targets: Vec::new(),
            rigs,
            weights,
            worn,
            motions: Vec::new(),
            imported_motions: Vec::new(),
            is_open: false,
            poses: Vec::new(),
            stored_poses: Vec::new(),
            pose_units: Vec::new(),
            view,
            slider_ends: Vec::new(),
            by_path,
            landmarks: OnceLock::new(),
        }
    }

    /// Whose body it is.
    pub const fn application(&self) -> Application {
        self.view.application()
    }

    /// Whether the application gets through the mesh of an asset.
    pub fn opens(&self, mesh: &AssetMesh) -> bool {
        let is_mixed = !mesh.facts.partial_uv.is_empty();
        mesh.is_sound() && (!is_mixed || self.is_makehuman1())
    }

    /// Whether `MakeHuman` 1 has it.
    pub fn is_before(&self, version: &str) -> bool {
        self.layers.are_before(self.application(), version)
    }

    /// Whether it is that of `MakeHuman` 1.
    pub const fn is_makehuman1(&self) -> bool {
        self.view.is_makehuman1()
    }

    /// Whether MPFB has it, which reads targets otherwise.
    pub const fn is_mpfb(&self) -> bool {
        self.view.is_mpfb()
    }

    /// The units that a pose is made of, if they could be read.
    pub fn units_of(&self, pose: &BodyPose<'_>) -> Option<(&'v FileFacts, &'v PoseUnits)> {
        let category = if pose.is_expression {
            "expressions"
        } else {
            "poses"
        };
        self.pose_units
            .iter()
            .find(|units| units.category == category)?
            .units
    }

    /// The names of the units that a pose can set, if they could be read.
    pub fn unit_names(&self, pose: &BodyPose<'_>) -> Option<(&'v FileFacts, &BTreeSet<&'v str>)> {
        let category = if pose.is_expression {
            "expressions"
        } else {
            "poses"
        };
        let mut own = self.pose_units.iter();
        own.find(|units| units.category == category)?.names()
    }

    /// The rig that the application poses the body with.
    pub fn default_rig(&self) -> Option<&'v Rig<'v>> {
        self.rigs.iter().find(|rig| rig.is_default)
    }

    /// The weights file of the default rig.
    pub fn default_weights(&self) -> Option<&'v FileFacts> {
        self.default_rig()?.weights_file()
    }

    /// Weights for its own mesh.
    pub fn own_weights(&self) -> impl Iterator<Item = &BodyWeights<'v>> {
        self.weights.iter().filter(|weights| weights.name.is_some())
    }

    /// Adds weights for other meshes than its own. Those that lie beside what is worn are for that:
    /// they are read if some of it names them.
    pub(super) fn add_worn_weights(&mut self, files: impl IntoIterator<Item = &'v FileFacts>) {
        let named: BTreeSet<&str> = self
            .worn
            .iter()
            .flat_map(Worn::weights)
            .map(|file| file.path.as_str())
            .collect();
        let mut is_known: BTreeMap<&str, bool> = BTreeMap::new();
        for worn in self.worn {
            *is_known.entry(worn.file.folder()).or_insert(true) &= worn.references.is_some();
        }
        let used = |file: &FileFacts| {
            let can_tell = is_known
                .get(file.folder())
                .is_some_and(|is_known| *is_known);
            if can_tell && !named.contains(file.path.as_str()) {
                WeightsUse::Unread
            } else {
                WeightsUse::Applied
            }
        };
        self.weights
            .extend(files.into_iter().map(|file| BodyWeights {
                file,
                name: None,
                used: used(file),
            }));
    }

    /// A vertex with its place on the body: ``vertex 17960 (`helper-tights`, near `pelvis.L`)``.
    pub fn vertex(&self, vertex: impl TryInto<u32> + Display + Copy) -> String {
        let known = self
            .whole_mesh()
            .map(|mesh| self.landmarks(mesh).vertex(vertex));
        known.unwrap_or_else(|| format!("vertex {vertex}"))
    }

    /// Vertices that a face uses, without those in `reached`, which are in order. None without a
    /// whole mesh, or if all are reached.
    pub fn unreached<'b>(&'b self, reached: &'b [u32]) -> Option<Unreached<'b>> {
        // Most weights reach every vertex: then the mesh is not walked.
        let mesh = self
            .whole_mesh()
            .filter(|_| self.doubt != Some(Doubt::Foreign));
        let mesh = mesh.filter(|mesh| reached.len() < mesh.positions.len())?;
        let unreached = self.landmarks(mesh).unreached(reached);
        (unreached.count > 0).then_some(unreached)
    }

    /// What a vertex is part of; `None` where the mesh, or what of it is shown, is not known.
    pub fn region(&self, vertex: u32) -> Option<Region> {
        let mesh = self
            .whole_mesh()
            .filter(|_| self.visible_groups.is_some())?;
        Some(self.landmarks(mesh).region(vertex))
    }

    fn landmarks(&self, mesh: &'v Mesh) -> &Landmarks<'v> {
        let skeleton = || self.default_rig().and_then(Rig::skeleton);
        self.landmarks
            .get_or_init(|| Landmarks::of(mesh, skeleton(), |group| self.shows(group)))
    }

    /// Whether a group of the mesh is shown; where that is said nowhere, all of them are.
    pub fn shows(&self, group: &str) -> bool {
        self.visible_groups
            .is_none_or(|visible| visible.contains(group))
    }

    /// The mesh, if every line of it could be read. Otherwise vertices have other numbers than
    /// their author meant.
    pub fn whole_mesh(&self) -> Option<&'v Mesh> {
        self.mesh
            .map(|(_, mesh)| mesh)
            .filter(|mesh| mesh.facts.unreadable_lines == 0)
    }

    /// The target at a printed path.
    pub fn target(&self, path: &str) -> Option<&Target<'v>> {
        self.targets.get(*self.by_path.get(path)?)
    }

    /// The folder that a target belongs to.
    pub fn folder_of<'f>(&self, file: &'f FileFacts) -> &'f str
    where
        'v: 'f,
    {
        self.target(&file.path)
            .map_or_else(|| parent(&file.rel), |target| target.folder)
    }

    /// Whether a target lies where the folder of a base mesh is missing, or in that of one that no
    /// layer has: nobody loads it.
    pub fn is_without_base(&self, file: &FileFacts) -> bool {
        let View::Makehuman2(view) = self.view else {
            return false;
        };
        view.is_unsorted(file) || !file.is_loose && view.is_nowhere(self.name)
    }

    /// A setting at which a target is applied fully; `None` if nothing uses it.
    pub fn shown_at(&self, file: &FileFacts) -> Option<Shown<'v>> {
        self.view.shown_at(file)
    }
}

impl<'v> Target<'v> {
    /// The archive that stands for its text.
    pub fn archive(&self) -> Option<&'v Archive> {
        self.packed_in?
            .archive()
            .filter(|archive| archive.is_sound())
    }

    /// Its copy in that archive.
    pub fn member(&self) -> Option<&'v Member> {
        let folder = parent(&self.packed_in?.rel);
        self.archive()?.member(
            self.file
                .rel
                .strip_prefix(folder)?
                .strip_prefix('/')?
                .strip_suffix(".target")?,
        )
    }

    /// Whether nobody parses its text: the archive has it, or nothing asks for it.
    pub fn is_unread(&self) -> bool {
        self.archive().is_some() && (self.is_unused || self.member().is_some())
    }

    /// Whether the archive has other numbers than the text, so that those of the text are not
    /// applied.
    pub fn is_outdated(&self) -> bool {
        let rows = self.member().and_then(|member| member.rows.as_ref().ok());
        rows.zip(self.file.target())
            .is_some_and(|(rows, facts)| rows.content != facts.content)
    }
}
