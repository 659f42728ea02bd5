//! A base of a MakeHuman 2 repository made ready for settings.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::opened::{MacroNames, NO_MESH};
use crate::outputs::rounded;
use crate::{Error, Evaluation};
use mhlint_eval::scene::Scene;
use mhlint_eval::vector::Point;
use mhlint_repo::Layers;
use mhlint_repo::makehuman2::{Base, BoundSlider};
use mhlint_source::Limits;

use super::compose::compose;
use super::stops;
use crate::Rows;
use crate::data::SkeletonFile;
use mhlint_diag::Application;

const OWN: Application = Application::Makehuman2;

/// Names of the bases that have a mesh.
pub(crate) fn with_mesh(layers: Layers<'_>) -> BTreeSet<&str> {
    let files = layers
        .strongest_first()
        .flat_map(|layer| layer.files.values());
    let own = files.filter(|file| file.kind_in(OWN).is_base_mesh() && file.mesh().is_some());
    own.filter_map(|file| file.base_in(OWN)).collect()
}

/// Takes what the files of a base hold, but for the rows of its targets.
///
/// # Errors
/// An unusable mesh.
pub(crate) fn open(base: &Base<'_>, limits: Limits) -> Result<Evaluation, Error> {
    let name = base.name;
    let read = base
        .mesh_files
        .read
        .map_or_else(|| format!("base/{name}/base.obj"), |file| file.path.clone());
    let no_mesh = || Error::file(&read, NO_MESH);
    let (file, mesh) = base.mesh.ok_or_else(no_mesh)?;
    if let Some(bad) = mesh.facts.unreadable.first() {
        return Err(Error::file(
            &file.path,
            format!("line {}: {} (`{}`)", bad.line, bad.what, bad.text),
        ));
    }
    let scene = compose(base, &Rows::new()).ok_or_else(no_mesh)?.scene;
    Ok(Evaluation {
        application: Application::Makehuman2,
        trees: Vec::new(),
        limits,
        base: name.to_owned(),
        size: mesh.size(),
        keys: base.sliders.iter().map(key_and_patterns).collect(),
        macros: macros_of(base, &scene),
        mesh_path: file.path.clone(),
        skeleton: skeleton_of(base),
        weights_fault: weights_fault(base, &scene),
        archive: base
            .targets
            .and_then(|folder| folder.archive())
            .and_then(|file| {
                let members = file
                    .archive()?
                    .members
                    .iter()
                    .map(|member| (member.name.clone(), member.name.clone()));
                Some((file.path.clone(), members.collect()))
            }),
        scene,
        groups: Vec::new(),
    })
}

impl Evaluation {
    /// The box that MakeHuman 2 itself reports: positions of the vertices that are extreme in the
    /// unmorphed visible body, where vertices of no visible face count as the origin.
    pub(crate) fn visible_box(&self, positions: &[Point]) -> Value {
        let scene = &self.scene;
        let mut shown = vec![[0.0_f32; 3]; scene.positions.len()];
        for (face, group) in scene.faces().zip(&scene.face_groups) {
            if scene.visible.get(*group as usize).copied().unwrap_or(false) {
                for vertex in face.iter().map(|vertex| *vertex as usize) {
                    if let (Some(place), Some(position)) =
                        (shown.get_mut(vertex), scene.positions.get(vertex))
                    {
                        *place = *position;
                    }
                }
            }
        }
        let extreme = |axis: usize, low: bool| {
            let better = |a: f32, b: f32| if low { a < b } else { a > b };
            let first = |best: usize, v: usize| {
                if better(shown[v][axis], shown[best][axis]) {
                    v
                } else {
                    best
                }
            };
            let vertex = (0..shown.len()).fold(0, first);
            positions
                .get(vertex)
                .map_or(Value::Null, |p| rounded(f64::from(p[axis])))
        };
        let side = |low: bool| Value::from([0, 1, 2].map(|axis| extreme(axis, low)).to_vec());
        json!([side(true), side(false)])
    }
}

/// Weights of a bone that the skeleton lacks, or for a vertex that the mesh lacks
/// (`docs/loaders/makehuman2/weights.md#faults-of-weights`).
fn weights_fault(base: &Base<'_>, scene: &Scene) -> Option<Error> {
    let (file, weights) = base.pose_rig()?.0.usable_weights()?;
    let names: BTreeSet<&String> = scene.skeleton.as_ref()?.names.iter().collect();
    let stops = |exception, reason| Some(stops(exception, reason));
    for bone in weights.bones.iter().filter(|bone| !bone.pairs.is_empty()) {
        if !names.contains(&bone.name) {
            return stops(
                "KeyError",
                format!(
                    "`{}` has weights for bone `{}`, which the skeleton does not have",
                    file.path, bone.name
                ),
            );
        }
        let outside = |vertex: i64| {
            usize::try_from(vertex).map_or(true, |vertex| vertex >= scene.positions.len())
        };
        if let Some(pair) = bone.pairs.iter().find(|pair| outside(pair.vertex)) {
            let reason = format!(
                "`{}` has a weight for vertex {} of bone `{}`, but the mesh has {} vertices",
                file.path,
                pair.vertex,
                bone.name,
                scene.positions.len()
            );
            return stops(
                if pair.vertex < 0 {
                    "OverflowError"
                } else {
                    "IndexError"
                },
                reason,
            );
        }
    }
    None
}

fn key_and_patterns(bound: &BoundSlider<'_>) -> (String, Vec<String>) {
    (bound.slider.key.clone(), bound.pattern.names().to_vec())
}

fn macros_of(base: &Base<'_>, scene: &Scene) -> Result<MacroNames, String> {
    match base.macro_file() {
        Some((file, _)) if scene.macros.is_none() => Err(format!(
            "`{}` has too many combinations to evaluate",
            file.path
        )),
        Some((_, macros)) => Ok(MacroNames::Components(macros.clone())),
        None if base.macros.is_broken() => {
            let file = base
                .macros
                .contarget
                .file()
                .or_else(|| base.macros.system.file());
            Err(format!(
                "`{}` cannot be used",
                file.map_or("macro.json", |file| file.path.as_str())
            ))
        }
        None => Err("macro.json is missing".to_owned()),
    }
}

fn skeleton_of(base: &Base<'_>) -> Result<SkeletonFile, String> {
    if let Some((rig, model)) = base.pose_rig() {
        return Ok(SkeletonFile {
            path: rig.file.path.clone(),
            model: model.clone(),
        });
    }
    let Some((file, settings)) = base.settings() else {
        return Err("no skeleton, because base.json is missing or cannot be used".to_owned());
    };
    Err(match &settings.pose_skeleton {
        None => format!("`{}` has no `pose-skeleton`", file.path),
        Some(name) => format!(
            "the pose skeleton `rigs/{}/{name}` is missing or cannot be used",
            base.name
        ),
    })
}
