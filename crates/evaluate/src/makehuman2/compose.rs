//! A base mesh with the rows of its targets to a scene of plain arrays.
//!
//! Takes what the application would take; what cannot be used (missing file, damaged rows) is left
//! out and named by rules of its own.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::references::Giver;
use crate::Rows;
use crate::files::take_mesh;
use crate::gauge::{Composed, Rig};
use crate::rows::{Suspects, is_usable};
use mhlint_eval::load::load;
use mhlint_eval::macros::Macros;
use mhlint_eval::makehuman2::MacroTable;
use mhlint_eval::makehuman2::macro_def::{Blend, Component, Macrodef, Slider};
use mhlint_eval::makehuman2::rest::hierarchy;
use mhlint_eval::measures::Received;
use mhlint_eval::scene::{MorphTarget, Scene, SceneSlider, SliderKind};
use mhlint_eval::settings::Dimension;
use mhlint_eval::skeleton::{Bone, SceneSkeleton};
use mhlint_eval::weights::{Entry, LoadedWeights};
use mhlint_formats::macro_json::{self, MacroFile};
use mhlint_formats::mhskel::{self, Plane, RotationPlane, Skeleton};
use mhlint_formats::mhw::Weights;
use mhlint_formats::obj::Mesh;
use mhlint_formats::target::Row;
use mhlint_repo::makehuman2::{Base, Pattern, TargetFolder};
use mhlint_repo::shortened;

/// Barycentric sets after a reset, whatever `default` says.
const BARYCENTRIC_DEFAULTS: [f64; 3] = [0.33, 0.33, 0.34];

/// The scene of a base, with those of the `rows` that its targets have. `None` without a mesh.
pub(crate) fn compose(base: &Base<'_>, rows: &Rows) -> Option<Composed> {
    // With lines that could not be read, vertices have other numbers than their author meant.
    let (_, mesh) = base
        .mesh
        .filter(|(_, mesh)| mesh.facts.unreadable_lines == 0)?;
    let mut composer = Composer {
        rows,
        mesh,
        suspects: Suspects::new(mesh),
        by_path: BTreeMap::new(),
        scene: Scene::default(),
    };
    composer.mesh(base);
    let registered = composer.sliders(base);
    match base.macro_file() {
        Some((_, file)) if file.is_too_large => composer.scene.lacks_macros = true,
        Some((_, file)) => composer.macros(base, file, &registered),
        None => {}
    }
    let mut scene = composer.scene;
    if let Some((rig, skeleton)) = base.pose_rig() {
        scene.skeleton = skeleton_of(skeleton, mesh.positions.len()).ok();
        let weights = rig.usable_weights().map(|(_, weights)| weights);
        scene.weights = scene
            .skeleton
            .as_ref()
            .zip(weights)
            .and_then(|(bones, weights)| bind(bones, weights, mesh));
    }
    let mut giver = Giver::of(&scene);
    let rigs = base.rigs.iter().filter_map(|rig| {
        let model = rig.skeleton()?;
        let skeleton = skeleton_of(model, mesh.positions.len()).ok()?;
        let giver = giver.as_mut().filter(|_| !rig.is_default);
        let received = giver.map_or_else(Received::default, |giver| giver.received(model));
        Some(Rig {
            path: rig.file.path.clone(),
            skeleton,
            received,
        })
    });
    let rigs = rigs.collect();
    let is_cut = giver.is_some_and(|giver| giver.is_cut);
    Some(Composed {
        scene,
        rigs,
        is_cut,
    })
}

struct Composer<'r, 'm> {
    rows: &'r Rows,
    mesh: &'m Mesh,
    suspects: Suspects<'m>,
    by_path: BTreeMap<String, usize>,
    scene: Scene,
}

impl Composer<'_, '_> {
    fn mesh(&mut self, base: &Base<'_>) {
        let visible = base
            .settings()
            .and_then(|(_, settings)| settings.shown.as_ref());
        take_mesh(&mut self.scene, self.mesh, |group| {
            visible.is_some_and(|names| names.contains(group))
        });
    }

    /// Binds all sliders; gives where each pattern is found in the macro settings.
    fn sliders(&mut self, base: &Base<'_>) -> BTreeMap<String, Slider> {
        let mut registered = BTreeMap::new();
        for bound in &base.sliders {
            let slider = bound.slider;
            match &bound.pattern {
                Pattern::Barycentric(patterns) => self.barycentric(patterns, &mut registered),
                Pattern::Macro(pattern) => {
                    let place = self.setting(pattern, slider.default.unwrap_or(0.0));
                    registered.insert(pattern.clone(), Slider::Value(place));
                }
                Pattern::Pair(pattern) | Pattern::Single(pattern) => {
                    let folder = base.folder_of(bound);
                    let incr = slider.incr.as_ref().map(|name| self.target(folder, name));
                    let decr = slider.decr.as_ref().map(|name| self.target(folder, name));
                    let two_sided = matches!(bound.pattern, Pattern::Pair(_));
                    self.scene.sliders.push(SceneSlider {
                        pattern: pattern.clone(),
                        kind: SliderKind::Detail {
                            incr,
                            decr,
                            two_sided,
                        },
                        default: slider.default.unwrap_or(0.0),
                    });
                }
                Pattern::None => {}
            }
        }
        registered
    }

    fn barycentric(&mut self, patterns: &[String], registered: &mut BTreeMap<String, Slider>) {
        let first = self.scene.macro_defaults.len();
        for (pattern, default) in patterns.iter().zip(BARYCENTRIC_DEFAULTS) {
            self.setting(pattern, default);
            registered.insert(
                pattern.clone(),
                Slider::Barycentric([first, first + 1, first + 2]),
            );
        }
    }

    fn setting(&mut self, pattern: &str, default: f64) -> usize {
        let place = self.scene.macro_defaults.len();
        self.scene.macro_defaults.push(default);
        self.scene.sliders.push(SceneSlider {
            pattern: pattern.to_owned(),
            kind: SliderKind::Macro(place),
            default,
        });
        place
    }

    /// Place of a target among the scene's, taking its rows the first time.
    fn target(&mut self, folder: Option<TargetFolder<'_>>, name: &str) -> usize {
        let file = folder.and_then(|folder| folder.target(name));
        let path = file.map_or_else(|| name.to_owned(), |file| file.path.clone());
        if let Some(place) = self.by_path.get(&path) {
            return *place;
        }
        let rows = file
            .filter(|file| file.target().is_some_and(is_usable))
            .and_then(|file| self.rows.get(&file.path).cloned());
        let vertices = self.mesh.positions.len();
        // Rows for seam duplicates are accepted and overwritten by the application.
        let in_mesh = |row: &Row| (row.0 as usize) < vertices;
        let rows = rows.map(|rows| {
            let is_whole = rows.iter().all(in_mesh);
            if is_whole {
                rows
            } else {
                Arc::new(rows.iter().copied().filter(in_mesh).collect())
            }
        });
        let place = self.scene.targets.len();
        self.by_path.insert(path.clone(), place);
        let suspect = file.is_some_and(|file| self.suspects.has(file));
        self.scene.targets.push(MorphTarget {
            name: name.to_owned(),
            path,
            rows,
            suspect,
        });
        place
    }

    fn macros(&mut self, base: &Base<'_>, file: &MacroFile, registered: &BTreeMap<String, Slider>) {
        let mut numbers: BTreeMap<usize, u32> = BTreeMap::new();
        let mut macrodefs = Vec::new();
        for macrodef in &file.macrodefs {
            let folder = macrodef.effective_folder.as_deref().unwrap_or_default();
            let mut links = Vec::new();
            for link in &macrodef.links {
                let number = link.target.as_ref().map(|target| {
                    let place = self.target(
                        base.targets,
                        &format!("{}/{}", shortened(folder), shortened(target)),
                    );
                    let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
                    *numbers.entry(place).or_insert_with(|| {
                        self.scene.macro_targets.push(place);
                        next
                    })
                });
                links.push((link.name.as_str(), number));
            }
            macrodefs.push(Macrodef {
                components: macrodef.components.iter().map(String::as_str).collect(),
                links,
            });
        }
        let by_name: BTreeMap<&str, Option<Dimension>> = file
            .components
            .iter()
            .map(|one| (one.name.as_str(), dimension(one, registered)))
            .collect();
        let products = file
            .macrodefs
            .iter()
            .map(|macrodef| dimensions(&by_name, &macrodef.components));
        self.scene.products = products.collect();
        let components: Vec<Component<'_>> = file.components.iter().filter_map(component).collect();
        let table = MacroTable::new(&components, &macrodefs, |pattern| {
            registered.get(pattern).copied()
        });
        // Too many combinations to tabulate is a limit of ours.
        self.scene.lacks_macros = table.is_err();
        self.scene.macros = table.ok().map(Macros::Makehuman2);
    }
}

/// Sliders of the components of a macrodef; empty where one of them is undefined or unbound, which
/// is reported for itself.
fn dimensions(by_name: &BTreeMap<&str, Option<Dimension>>, names: &[String]) -> Vec<Dimension> {
    names
        .iter()
        .map(|name| by_name.get(name.as_str())?.clone())
        .collect::<Option<_>>()
        .unwrap_or_default()
}

/// The slider of a component, if it is bound.
fn dimension(
    component: &macro_json::Component,
    registered: &BTreeMap<String, Slider>,
) -> Option<Dimension> {
    let pattern = component.pattern.as_deref()?;
    match (&component.steps, &component.sum) {
        (Some(steps), _) => match registered.get(pattern)? {
            Slider::Value(place) => Some(Dimension::Steps {
                place: *place,
                steps: steps.as_slice().into(),
            }),
            Slider::Barycentric(_) => None,
        },
        (None, Some(sum)) => {
            let place = |(value, end): (usize, &String)| match registered
                .get(&format!("{pattern}{end}"))?
            {
                Slider::Barycentric(places) => places.get(value).copied(),
                Slider::Value(_) => None,
            };
            Some(Dimension::Corners(
                sum.iter().enumerate().map(place).collect::<Option<_>>()?,
            ))
        }
        (None, None) => None,
    }
}

fn component(component: &macro_json::Component) -> Option<Component<'_>> {
    let blend = match (&component.steps, &component.sum) {
        (Some(steps), _) => Blend::Steps(steps.clone()),
        (None, Some(sum)) => Blend::Sum(sum.iter().map(String::as_str).collect()),
        (None, None) => return None,
    };
    Some(Component {
        name: &component.name,
        pattern: component.pattern.as_deref()?,
        values: component.values.iter().map(String::as_str).collect(),
        blend,
    })
}

/// Bones in an order with parents first, or the first thing that makes the application refuse the
/// skeleton or stop.
pub(crate) fn skeleton_of(skeleton: &Skeleton, vertices: usize) -> Result<SceneSkeleton, String> {
    let mut out = SceneSkeleton::default();
    for joint in &skeleton.joints {
        // A joint without vertices does not exist for the application; it matters only where a bone
        // names it.
        let Some(list) = joint.vertices.as_deref().filter(|list| !list.is_empty()) else {
            continue;
        };
        let outside = |vertex| {
            format!(
                "joint `{}` uses vertex {vertex}, but the mesh has {vertices} vertices",
                joint.name
            )
        };
        let number = |vertex: &i64| joint_vertex(*vertex, vertices).ok_or_else(|| outside(*vertex));
        out.joints
            .push(list.iter().map(number).collect::<Result<_, _>>()?);
        out.joint_names.push(joint.name.clone());
    }
    let by_name = first_places(skeleton.bones.iter().map(|bone| bone.name.as_str()));
    let parents = skeleton
        .bones
        .iter()
        .map(|bone| by_name.get(bone.parent.as_deref()?).copied());
    let parents: Vec<Option<usize>> = parents.collect();
    let joints = first_places(out.joint_names.iter().map(String::as_str));
    let joint = |name: &str| joints.get(name).copied();
    let by_plane = first_places(skeleton.planes.iter().map(|plane| plane.name.as_str()));
    let bone = |bone: &mhskel::Bone| {
        let name = &bone.name;
        let end = |end: &str, at: &Option<String>| {
            let at = at
                .as_ref()
                .ok_or_else(|| format!("bone `{name}` has no {end}"))?;
            joint(at).ok_or_else(|| {
                format!("the {end} of bone `{name}` is joint `{at}`, which has no vertices")
            })
        };
        let (head, tail) = (end("head", &bone.head)?, end("tail", &bone.tail)?);
        if let Some(parent) = bone
            .parent
            .as_ref()
            .filter(|parent| !by_name.contains_key(parent.as_str()))
        {
            return Err(format!(
                "the parent `{parent}` of bone `{name}` does not exist"
            ));
        }
        let plane = match &bone.rotation_plane {
            RotationPlane::Absent => None,
            RotationPlane::Malformed => {
                return Err(format!("`rotation_plane` of bone `{name}` is not a name"));
            }
            RotationPlane::Named(plane) => {
                let found = by_plane
                    .get(plane.as_str())
                    .and_then(|at| skeleton.planes.get(*at));
                let three = found.and_then(|found| plane_joints(found, joint));
                Some(three.ok_or_else(|| {
                    format!("plane `{plane}` of bone `{name}` does not have three joints")
                })?)
            }
        };
        Ok(Bone {
            parent: None,
            head,
            tail,
            plane,
        })
    };
    let bones: Vec<Result<Bone, String>> = skeleton.bones.iter().map(bone).collect();
    let first_fault = |fault: String| {
        bones
            .iter()
            .find_map(|bone| bone.clone().err())
            .unwrap_or(fault)
    };
    // A bone without known parent is a root here, so that it is reached or a second one. Others
    // that are not reached from the root do not exist for the application, whatever is wrong with
    // them.
    let order = hierarchy(&parents).map_err(|fault| first_fault(fault.to_string()))?;
    let places: BTreeMap<usize, usize> = order
        .iter()
        .enumerate()
        .map(|(place, old)| (*old, place))
        .collect();
    for old in &order {
        let (Some(bone), Some(model)) = (bones.get(*old), skeleton.bones.get(*old)) else {
            continue;
        };
        let parent = parents
            .get(*old)
            .copied()
            .flatten()
            .and_then(|parent| places.get(&parent).copied());
        out.bones.push(Bone {
            parent,
            ..bone.clone().map_err(first_fault)?
        });
        out.names.push(model.name.clone());
    }
    Ok(out)
}

/// A negative index counts from the end of the mesh with its seam duplicates; only the plain ones
/// are resolved here.
fn joint_vertex(vertex: i64, vertices: usize) -> Option<u32> {
    u32::try_from(vertex)
        .ok()
        .filter(|vertex| (*vertex as usize) < vertices)
}

/// Where each name stands, of equal ones the first.
pub(super) fn first_places<'n>(names: impl Iterator<Item = &'n str>) -> BTreeMap<&'n str, usize> {
    let mut places = BTreeMap::new();
    for (place, name) in names.enumerate() {
        places.entry(name).or_insert(place);
    }
    places
}

fn plane_joints(plane: &Plane, joint: impl Fn(&str) -> Option<usize>) -> Option<[usize; 3]> {
    match plane.joints.as_deref()? {
        [Some(a), Some(b), Some(c), ..] => Some([joint(a)?, joint(b)?, joint(c)?]),
        _ => None,
    }
}

/// Weights with bones numbered as in the skeleton, loaded as the application does.
fn bind(skeleton: &SceneSkeleton, weights: &Weights, mesh: &Mesh) -> Option<LoadedWeights> {
    let vertices = mesh.positions.len();
    let root = skeleton
        .bones
        .iter()
        .position(|bone| bone.parent.is_none())?;
    let numbers = first_places(skeleton.names.iter().map(String::as_str));
    let mut lists: Vec<(usize, Vec<Entry>)> = Vec::new();
    for bone in &weights.bones {
        let Some(number) = numbers.get(bone.name.as_str()).copied() else {
            continue;
        };
        let entry = |pair: &mhlint_formats::mhw::Pair| {
            Some((u32::try_from(pair.vertex).ok()?, pair.weight))
        };
        lists.push((
            number,
            bone.pairs
                .iter()
                .map(entry)
                .collect::<Option<Vec<Entry>>>()?,
        ));
    }
    let lists: Vec<(usize, &[Entry])> = lists
        .iter()
        .map(|(bone, entries)| (*bone, entries.as_slice()))
        .collect();
    load(&lists, root, vertices).ok()
}
