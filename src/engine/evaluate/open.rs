//! Opens one base mesh from data folders, as the application layers them.
//!
//! Everything but targets is read at once; rows of targets come when a setting needs them (`rows`).

use std::collections::BTreeSet;
use std::path::Path;

use super::error::Error;
use super::files::{read_cause, shown};
use super::skeleton::SkeletonFile;
use crate::diag::{Application, nearest};
use crate::engine::compose::{Rows, compose, pose_skeleton, weights_of};
use crate::engine::load::Data;
use crate::engine::load::roots_of;
use crate::engine::load::{Place, list_targets};
use crate::engine::load::{Role, Stack};
use crate::engine::load::{open, open_system};
use crate::eval::scene::Scene;
use crate::formats::macro_json::MacroFile;
use crate::formats::target::MeshSize;
use crate::repo::{Base, BoundSlider, Layer};
use crate::source::{Limits, Tree};

/// A base mesh ready for settings.
#[derive(Debug)]
pub struct Evaluation {
    pub(super) trees: Vec<Tree>,
    pub(super) limits: Limits,
    pub(super) base: String,
    pub(super) size: MeshSize,
    pub(super) scene: Scene,
    /// Keys of `modelling.json` with the patterns they register.
    pub(super) keys: Vec<(String, Vec<String>)>,
    pub(super) macros: Result<MacroFile, String>,
    pub(super) mesh_path: String,
    pub(super) skeleton: Result<SkeletonFile, String>,
    pub(super) weights_path: Option<String>,
    /// Why the application stops when it binds the weights.
    pub(super) weights_fault: Option<Error>,
    /// The archive that the application reads in place of target files, and the targets in it.
    pub(super) archive: Option<(String, BTreeSet<String>)>,
}

impl Evaluation {
    /// Opens a base of the data folder `root` (which lies over `system`, if given). Without `base` there must be
    /// only one.
    ///
    /// # Errors
    /// Folders that cannot be read or hold no data, a base that does not exist, an unusable `base.obj`.
    pub fn open(root: &Path, system: Option<&Path>, base: Option<&str>) -> Result<Self, Error> {
        let limits = Limits::default();
        let inputs = open(&[root.to_path_buf()])?;
        let judged = inputs.len();
        let mut trees: Vec<Tree> = inputs.into_iter().map(|input| input.tree).collect();
        trees.extend(system.map(open_system).transpose()?);
        let roots: Vec<Vec<String>> = trees.iter().map(makehuman_2_roots).collect();
        let places: Vec<Vec<Place<'_>>> = trees.iter().zip(&roots).map(|(tree, roots)| places(tree, roots)).collect();
        let (own, below) = places.split_at(judged.min(places.len()));
        let own: Vec<_> = own.iter().flatten().map(|place| (*place, Vec::new())).collect();
        let below = below.first().map(|places| places.first().copied());
        if own.is_empty() || matches!(below, Some(None)) {
            return Err(Error::NoData(shown(system.filter(|_| !own.is_empty()).unwrap_or(root))));
        }
        let mut data = Data::load(own, below.flatten(), &limits);
        for (loaded, _) in data.all_mut() {
            list_targets(loaded.place, &mut loaded.layer);
        }
        let (name, stack) = choose(&data, base)?;
        let evaluation = compose_base(&name, &stack, limits)?;
        drop(data);
        drop(places);
        Ok(Self { trees, ..evaluation })
    }

    /// Name of the base.
    pub fn base(&self) -> &str {
        &self.base
    }

    /// The arrays that are evaluated.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Path of `base.obj`.
    pub fn mesh_path(&self) -> &str {
        &self.mesh_path
    }

    /// Path of the weights of the pose skeleton, if there are any.
    pub fn weights_path(&self) -> Option<&str> {
        self.weights_path.as_deref()
    }

    /// The bytes of `base.obj`.
    ///
    /// # Errors
    /// When it cannot be read any more.
    pub fn mesh_text(&self) -> Result<Vec<u8>, Error> {
        let gone = || Error::file(&self.mesh_path, "is gone");
        let (tree, entry) = self.entry(&self.mesh_path).ok_or_else(gone)?;
        let read = tree.read(entry, &self.limits);
        read.map_err(|fault| Error::file(&self.mesh_path, read_cause(&fault)))
    }

    /// The listed file at a printed path.
    pub(super) fn entry(&self, path: &str) -> Option<(&Tree, &crate::source::Entry)> {
        self.trees.iter().find_map(|tree| {
            let rel =
                if tree.label().is_empty() { path } else { path.strip_prefix(tree.label())?.strip_prefix('/')? };
            Some((tree, tree.entry(rel)?))
        })
    }
}

fn places<'t>(tree: &'t Tree, roots: &'t [String]) -> Vec<Place<'t>> {
    roots.iter().map(|root| Place { tree, root, moved: None }).collect()
}

fn makehuman_2_roots(tree: &Tree) -> Vec<String> {
    let roots = roots_of(tree).into_iter();
    roots.filter(|root| root.application == Application::Makehuman2).map(|root| root.path).collect()
}

/// The base asked for, and the layers it is seen through.
fn choose<'a, 't>(data: &'a Data<'t>, base: Option<&str>) -> Result<(String, Stack<'a, 't>), Error> {
    let stacks = data.stacks();
    let known: BTreeSet<&str> = stacks.iter().flat_map(meshes).collect();
    let list = || known.iter().map(|name| (*name).to_owned()).collect();
    let name = match (base, known.first()) {
        (Some(name), _) if known.contains(name) => name.to_owned(),
        (Some(name), _) => {
            let nearest = nearest(name, known.iter().copied()).map(str::to_owned);
            return Err(Error::UnknownBase { name: name.to_owned(), nearest, known: list() });
        }
        (None, Some(only)) if known.len() == 1 => (*only).to_owned(),
        (None, _) => {
            let with_macros = stacks.iter().flat_map(|stack| with_macros(stack, &known)).collect::<BTreeSet<_>>();
            return Err(Error::BaseNeeded { known: list(), with_macros: with_macros.into_iter().collect() });
        }
    };
    let mut holding: Vec<Stack<'a, 't>> =
        stacks.into_iter().filter(|stack| meshes(stack).iter().any(|mesh| *mesh == name)).collect();
    // A user folder is seen with the system data below it, so it is the fuller view.
    if holding.iter().any(|(_, _, judged)| judged.role != Role::System) {
        holding.retain(|(_, _, judged)| judged.role != Role::System);
    }
    match holding.as_slice() {
        [only] => Ok((name, *only)),
        several => Err(Error::SeveralRoots(several.iter().map(|(_, _, judged)| judged.layer.path.clone()).collect())),
    }
}

fn layers<'a>(stack: &Stack<'a, '_>) -> Vec<&'a Layer> {
    [stack.0, stack.1].into_iter().flatten().collect()
}

/// Names of the bases that have a mesh.
fn meshes<'a>(stack: &Stack<'a, '_>) -> Vec<&'a str> {
    let files = layers(stack).into_iter().flat_map(|layer| layer.files.values());
    files.filter(|file| file.mesh().is_some()).filter_map(|file| file.base.as_deref()).collect()
}

fn with_macros(stack: &Stack<'_, '_>, known: &BTreeSet<&str>) -> Vec<String> {
    let has = |name: &&&str| Base::resolve(name, stack.0, stack.1).macro_file().is_some();
    known.iter().filter(has).map(|name| (*name).to_owned()).collect()
}

fn compose_base(name: &str, stack: &Stack<'_, '_>, limits: Limits) -> Result<Evaluation, Error> {
    let base = Base::resolve(name, stack.0, stack.1);
    let no_mesh = || Error::file(format!("base/{name}/base.obj"), "there is no mesh in it");
    let (file, mesh) = base.mesh.ok_or_else(no_mesh)?;
    if let Some(bad) = mesh.facts.unreadable.first() {
        return Err(Error::file(&file.path, format!("line {}: {} (`{}`)", bad.line, bad.what, bad.text)));
    }
    let scene = compose(&base, &mut Rows::new()).ok_or_else(no_mesh)?.scene;
    let vertices = mesh.facts.vertices;
    Ok(Evaluation {
        trees: Vec::new(),
        limits,
        base: name.to_owned(),
        size: MeshSize { vertices, with_seams: vertices + mesh.facts.seam_duplicates },
        keys: base.sliders.iter().map(key_and_patterns).collect(),
        macros: macros_of(&base, &scene),
        mesh_path: file.path.clone(),
        skeleton: skeleton_of(&base),
        weights_path: pose_skeleton(&base)
            .and_then(|(file, skeleton)| weights_of(&base, file, skeleton))
            .map(|(file, _)| file.path.clone()),
        weights_fault: weights_fault(&base, &scene),
        archive: base.targets.and_then(|folder| folder.archive()).and_then(|file| {
            let members = file.archive()?.members.iter().map(|member| member.name.clone());
            Some((file.path.clone(), members.collect()))
        }),
        scene,
    })
}

/// Weights of a bone that the skeleton lacks, or for a vertex that the mesh lacks (formats/makehuman2.md §11).
fn weights_fault(base: &Base<'_>, scene: &Scene) -> Option<Error> {
    let (skeleton, model) = pose_skeleton(base)?;
    let (file, weights) = weights_of(base, skeleton, model)?;
    let names = &scene.skeleton.as_ref()?.names;
    let stops = |exception, reason| Some(Error::Stops { exception, reason });
    for bone in weights.bones.iter().filter(|bone| !bone.pairs.is_empty()) {
        if !names.contains(&bone.name) {
            return stops(
                "KeyError",
                format!("`{}` has weights for `{}`, which the skeleton lacks", file.path, bone.name),
            );
        }
        let outside = |vertex: i64| usize::try_from(vertex).map_or(true, |vertex| vertex >= scene.positions.len());
        if let Some(pair) = bone.pairs.iter().find(|pair| outside(pair.vertex)) {
            let reason = format!(
                "`{}` weighs vertex {} for `{}`; the mesh has {}",
                file.path,
                pair.vertex,
                bone.name,
                scene.positions.len()
            );
            return stops(if pair.vertex < 0 { "OverflowError" } else { "IndexError" }, reason);
        }
    }
    None
}

fn key_and_patterns(bound: &BoundSlider<'_>) -> (String, Vec<String>) {
    (bound.slider.key.clone(), bound.pattern.names().to_vec())
}

fn macros_of(base: &Base<'_>, scene: &Scene) -> Result<MacroFile, String> {
    match base.macro_file() {
        Some((file, _)) if scene.macros.is_none() => {
            Err(format!("`{}` has more combinations than are evaluated", file.path))
        }
        Some((_, macros)) => Ok(macros.clone()),
        None if base.macros.is_broken() => {
            let file = base.macros.contarget.file().or_else(|| base.macros.system.file());
            Err(format!("`{}` cannot be used", file.map_or("macro.json", |file| file.path.as_str())))
        }
        None => Err("there is no macro.json".to_owned()),
    }
}

fn skeleton_of(base: &Base<'_>) -> Result<SkeletonFile, String> {
    if let Some((file, model)) = pose_skeleton(base) {
        return Ok(SkeletonFile { path: file.path.clone(), model: model.clone() });
    }
    let Some((file, settings)) = base.settings() else {
        return Err("no skeleton, since there is no usable base.json".to_owned());
    };
    Err(match &settings.pose_skeleton {
        None => format!("`{}` names no pose-skeleton", file.path),
        Some(name) => format!("the pose skeleton `rigs/{}/{name}` is missing or cannot be used", base.name),
    })
}
