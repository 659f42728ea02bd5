//! A scene to its measures: the pure functions of `eval`, run in parallel and merged in order.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;

use mhlint_config::{Config, MOST_SAMPLES};
use mhlint_diag::Few;
use mhlint_eval::culprit::most_moving;
use mhlint_eval::fit::fit;
use mhlint_eval::look::look;
use mhlint_eval::macros::MacroWork;
use mhlint_eval::measures::{Measures, PairMeasure, Received, Seen, SkeletonMeasure};
use mhlint_eval::mesh::bounding_box;
use mhlint_eval::rig_measure::{bone_pairs, bones, exchanged, weights};
use mhlint_eval::scene::{MorphTarget, Scene, Setting};
use mhlint_eval::settings::{DEFAULT_SAMPLES, moved, plan};
use mhlint_eval::side::{self, Side};
use mhlint_eval::skeleton::SceneSkeleton;
use mhlint_eval::survey::{Fault, Survey, Trouble, merge};
use mhlint_eval::surveyor::Surveyor;
use mhlint_eval::symmetry::{MirrorComparison, MirrorMap};
use mhlint_eval::target_measure::{Parts, TargetMeasure, cubes_of, side_of};
use mhlint_eval::vector::Point;
use mhlint_eval::walk::{Stop, in_order};
use mhlint_source::folder_and_name;

/// How far from its exact mirror image a vertex may be, mesh units: meshes are written with four
/// decimals.
const MIRROR_TOLERANCE: f32 = 1e-3;
/// Displacements of mirrored vertices may differ by rounding to three decimals on either side, mesh
/// units.
const DELTA_TOLERANCE: f64 = 2.5e-3;
/// Weights of mirrored vertices may differ by this before they count.
const WEIGHT_TOLERANCE: f32 = 0.01;
/// Settings that one thread looks at in a row, starting from the base mesh.
const CHUNK: usize = 64;
/// Settings that are made ready at once.
const AT_ONCE: usize = 256;
/// Work on settings, in additions: several times that on hm08.
const MOST_WORK: u64 = 1 << 31;
/// The same where every corner of the slider space was asked for.
const MOST_EXHAUSTIVE_WORK: u64 = 1 << 38;
/// Targets that all settings together may add; hm08 has fifty thousand.
const MOST_ADDED: usize = 1 << 22;

/// A base mesh made ready for evaluation.
pub(super) struct Composed {
    pub(super) scene: Scene,
    /// Every skeleton of the base.
    pub(super) rigs: Vec<Rig>,
    /// Whether something was left out because it was too much work.
    pub(super) is_cut: bool,
}

/// A skeleton of a base.
pub(super) struct Rig {
    /// Printed path of its file.
    pub(super) path: String,
    pub(super) skeleton: SceneSkeleton,
    /// What it gets of the weights of the pose skeleton.
    pub(super) received: Received,
}

/// Measures a base mesh.
pub(super) fn gauge(composed: &Composed, options: &Config) -> Measures {
    let Composed { scene, rigs, .. } = composed;
    let samples = options.samples.unwrap_or(DEFAULT_SAMPLES).min(MOST_SAMPLES);
    let (settings, is_planned) = plan(scene, samples, options.exhaustive);
    let work = if options.exhaustive {
        MOST_EXHAUSTIVE_WORK
    } else {
        MOST_WORK
    };
    let ((space, is_cut), (macros, shape)) = rayon::join(
        || {
            survey(scene, &settings, work)
                .map_or((None, false), |(space, is_cut)| (Some(space), is_cut))
        },
        || {
            let macros = || {
                scene
                    .macros
                    .as_ref()
                    .map(|macros| macros.measure(scene, &settings))
            };
            rayon::join(macros, || shape(scene, rigs))
        },
    );
    let macros = macros.unwrap_or_default();
    let lacks_settings = scene.lacks_macros || macros.is_cut;
    Measures {
        lacks_settings,
        space,
        macros,
        is_cut: composed.is_cut || is_planned || is_cut,
        ..shape
    }
}

/// Everything that needs the default character only.
fn shape(scene: &Scene, rigs: &[Rig]) -> Measures {
    let mirror = MirrorMap::new(&scene.positions, scene.faces(), MIRROR_TOLERANCE);
    let (parts, cubes) = parts(scene);
    let rest = scene
        .morphed(&scene.defaults())
        .unwrap_or_else(|_| scene.positions.clone());
    let is_centred = is_centred(&rest);
    let weights = scene
        .skeleton
        .as_ref()
        .zip(scene.weights.as_ref())
        .and_then(|(skeleton, loaded)| {
            let mut measure = weights(
                loaded,
                skeleton,
                &rest,
                &mirror,
                &bone_pairs(&skeleton.names),
                WEIGHT_TOLERANCE,
            )?;
            measure.wrong_side.retain(|_| is_centred);
            Some(measure)
        });
    Measures {
        pairs: pair_measures(scene, &parts, &mirror),
        targets: target_measures(scene, &parts, &mirror),
        cubes,
        skeletons: rigs
            .iter()
            .filter_map(|rig| skeleton_measure(rig, &rest, is_centred))
            .collect(),
        weights,
        exchanged: if is_centred {
            exchanged_of(scene, &rest)
        } else {
            BTreeMap::new()
        },
        bones: scene
            .skeleton
            .as_ref()
            .map(|skeleton| skeleton.names.clone())
            .unwrap_or_default(),
        ..Measures::default()
    }
}

/// Bones that have each other's weights on what is worn, by path of these weights.
fn exchanged_of(scene: &Scene, rest: &[Point]) -> BTreeMap<String, Vec<usize>> {
    let Some(skeleton) = &scene.skeleton else {
        return BTreeMap::new();
    };
    let weighted = scene
        .worn
        .iter()
        .filter_map(|asset| Some((asset, asset.weights.as_ref()?)));
    let exchanged = weighted.filter_map(|(asset, (path, lists))| {
        let positions = fit(rest, &asset.references, asset.scales).ok()?;
        let bones = exchanged(
            lists,
            skeleton,
            rest,
            &positions,
            &bone_pairs(&skeleton.names),
        );
        (!bones.is_empty()).then(|| (path.clone(), bones))
    });
    exchanged.collect()
}

/// What settings add to the mesh, as many of them as there is work allowed for, and whether these
/// are all. Settings are made ready a few at a time: what many sliders add together can be more
/// than memory holds.
fn stops(surveyor: &Surveyor<'_>, settings: &[Setting], mut work: u64) -> (Vec<Stop>, bool) {
    let mut stops = Vec::new();
    let mut added = 0;
    for (part, settings) in settings.chunks(AT_ONCE).enumerate() {
        let stop = |work: &mut MacroWork, (place, setting): (usize, &Setting)| {
            surveyor.stop(part * AT_ONCE + place, setting, work)
        };
        let found: Vec<Option<Stop>> = (0..settings.len())
            .into_par_iter()
            .zip(settings)
            .map_init(MacroWork::default, stop)
            .collect();
        for stop in found.into_iter().flatten() {
            added += stop.target_count();
            let left = work
                .checked_sub(surveyor.cost(&stop))
                .filter(|_| added <= MOST_ADDED);
            let Some(left) = left else {
                return (stops, true);
            };
            work = left;
            stops.push(stop);
        }
    }
    (stops, false)
}

/// The name of a face, joint or bone.
type Name<'n> = &'n dyn Fn(usize) -> String;

/// What is seen over the slider space, and whether something was left out of it.
fn survey(
    scene: &Scene,
    settings: &[Setting],
    work: u64,
) -> Option<(BTreeMap<Trouble, Seen>, bool)> {
    let surveyor = Surveyor::new(scene)?;
    let (stops, is_cut) = stops(&surveyor, settings, work);
    let stops = in_order(stops);
    let parts: Vec<Survey> = stops
        .par_chunks(CHUNK)
        .map(|stops| look(&surveyor, stops))
        .collect();
    let mut survey = Survey::new();
    parts.into_iter().for_each(|part| merge(&mut survey, part));
    let group = |face: usize| {
        let group = scene
            .face_groups
            .get(face)
            .and_then(|group| scene.groups.get(*group as usize));
        group.cloned().unwrap_or_default()
    };
    let skeleton = scene.skeleton.as_ref();
    let joint = |joint: usize| {
        skeleton
            .and_then(|s| s.joint_names.get(joint))
            .cloned()
            .unwrap_or_default()
    };
    let bone = |bone: usize| {
        skeleton
            .and_then(|s| s.names.get(bone))
            .cloned()
            .unwrap_or_default()
    };
    let vertex = |vertex: usize| u32::try_from(vertex).into_iter().collect();
    let face = |face: usize| scene.face(face).to_vec();
    let of_joint = |joint: usize| {
        skeleton
            .and_then(|s| s.joints.get(joint))
            .cloned()
            .unwrap_or_default()
    };
    // A joint that drifts moves as a whole: one vertex of its cube stands for it.
    let of_cube = |joint: usize| of_joint(joint).into_iter().take(1).collect();
    let of_bone = |bone: usize| {
        let bone = skeleton.and_then(|s| s.bones.get(bone));
        let joints = bone.map(|bone| {
            [bone.head, bone.tail]
                .into_iter()
                .chain(bone.plane.into_iter().flatten())
        });
        joints.into_iter().flatten().flat_map(of_joint).collect()
    };
    let in_group = |face: usize| format!("{} {face}", group(face));
    let tied = |probe: usize| {
        surveyor
            .tied(probe)
            .map(|(_, named)| named.to_vec())
            .unwrap_or_default()
    };
    let of_asset = |probe: usize| {
        surveyor
            .tied(probe)
            .map(|(vertex, _)| format!("vertex {vertex}"))
            .unwrap_or_default()
    };
    let asset = |probe: usize| {
        surveyor
            .asset(probe)
            .map(|asset| asset.path.clone())
            .unwrap_or_default()
    };
    let space = survey
        .into_iter()
        .filter_map(|(trouble, Fault { worst, elements })| {
            let (worst, setting) = worst
                .and_then(|worst| settings.get(worst.setting).map(|setting| (worst, setting)))?;
            let (vertices, named): (Vec<u32>, Option<[Name<'_>; 2]>) = match trouble {
                Trouble::NonFinite | Trouble::Exploded => (vertex(worst.element), None),
                Trouble::Collapsed => (face(worst.element), Some([&group, &in_group])),
                Trouble::Flipped => (face(worst.element), Some([&group, &group])),
                Trouble::Drifted => (of_cube(worst.element), Some([&joint, &joint])),
                Trouble::ShortBone | Trouble::FlatPlane => {
                    (of_bone(worst.element), Some([&bone, &bone]))
                }
                Trouble::Detached(_) => (tied(worst.element), Some([&asset, &of_asset])),
            };
            let length = match trouble {
                Trouble::Exploded => Some(surveyor.length_outside(worst.value)),
                Trouble::Drifted => surveyor.length_away(worst.element, worst.value),
                Trouble::Detached(_) => surveyor.length_detached(worst.element, worst.value),
                _ => None,
            };
            let target =
                most_moving(scene, setting, &vertices).and_then(|target| scene.targets.get(target));
            let seen = Seen {
                value: worst.value,
                element: match trouble {
                    Trouble::Detached(_) => surveyor
                        .tied(worst.element)
                        .map_or(0, |(vertex, _)| vertex as usize),
                    _ => worst.element,
                },
                length,
                name: named.map_or_else(String::new, |[name, _]| name(worst.element)),
                count: worst.count,
                all: named.map_or_else(Vec::new, |[_, each]| {
                    few(elements.iter().map(|element| each(*element)))
                }),
                elements: elements.into_iter().collect(),
                setting: moved(scene, setting),
                target: target.map(|target| target.path.clone()),
            };
            Some((trouble, seen))
        });
    let space = space.collect();
    Some((space, is_cut || surveyor.is_without_anchors))
}

/// The names, or none where they are too many to be told apart.
fn few(all: impl Iterator<Item = String>) -> Vec<String> {
    let mut names = Few::default();
    all.for_each(|name| names.add_long(name.len(), || name));
    names.names().to_vec()
}

/// Parts of the mesh that targets are measured against, and the names of the joint cubes.
fn parts(scene: &Scene) -> (Parts, Vec<String>) {
    let groups = scene
        .face_groups
        .iter()
        .map(|group| scene.groups.get(*group as usize).map_or("", String::as_str));
    let mut cubes = cubes_of(groups.zip(scene.faces()));
    // A cube that no joint of the skeleton uses (the ground) may be deformed at will.
    let used: BTreeSet<u32> = scene
        .skeleton
        .iter()
        .flat_map(|skeleton| &skeleton.joints)
        .flatten()
        .copied()
        .collect();
    cubes.retain(|(_, vertices)| vertices.iter().any(|vertex| used.contains(vertex)));
    let mut parts = Parts {
        body: vec![false; scene.positions.len()],
        cube_of: vec![None; scene.positions.len()],
        cubes: cubes.iter().map(|(_, vertices)| vertices.clone()).collect(),
    };
    for (face, group) in scene.faces().zip(&scene.face_groups) {
        if scene.visible.get(*group as usize) == Some(&true) {
            for vertex in face {
                mark(&mut parts.body, *vertex as usize, true);
            }
        }
    }
    for (number, (_, vertices)) in (0..).zip(&cubes) {
        for vertex in vertices {
            mark(&mut parts.cube_of, *vertex as usize, Some(number));
        }
    }
    (parts, cubes.into_iter().map(|(name, _)| name).collect())
}

/// Every target that no other rule reports for its rows.
fn target_measures(scene: &Scene, parts: &Parts, mirror: &MirrorMap) -> Vec<TargetMeasure> {
    let measure = |comparison: &mut MirrorComparison<'_>, target: &MorphTarget| {
        let measure = parts.measure(target.rows.as_deref()?, comparison, DELTA_TOLERANCE);
        Some(TargetMeasure {
            name: target.name.clone(),
            path: target.path.clone(),
            ..measure
        })
    };
    let usable = scene.targets.par_iter().filter(|target| !target.suspect);
    usable
        .map_init(|| MirrorComparison::new(mirror), measure)
        .flatten()
        .collect()
}

fn mark<T>(list: &mut [T], at: usize, value: T) {
    if let Some(place) = list.get_mut(at) {
        *place = value;
    }
}

/// Targets of one folder named alike but for their side.
fn pair_measures(scene: &Scene, parts: &Parts, mirror: &MirrorMap) -> Vec<PairMeasure> {
    let usable = scene.targets.iter().filter(|target| !target.suspect);
    let by_path: BTreeMap<&str, &MorphTarget> = usable
        .map(|target| (target.path.as_str(), target))
        .collect();
    let is_centred = is_centred(&scene.positions);
    let is_on = |rows: &[(u32, Point)], side| side_of(rows, &scene.positions) == Some(side);
    let pair = |comparison: &mut MirrorComparison<'_>, left: &MorphTarget| {
        let right = by_path.get(right_of(&left.path)?.as_str())?;
        let (ours, theirs) = (left.rows.as_deref()?, right.rows.as_deref()?);
        let moves = |rows: &[(u32, Point)]| {
            rows.iter()
                .any(|(_, delta)| delta.iter().any(|part| *part != 0.0))
        };
        // A target without effect is a fault of its own.
        let (both, body) = parts.pair(ours, theirs, comparison, DELTA_TOLERANCE);
        let is_exchanged = is_centred && is_on(ours, Side::Right) && is_on(theirs, Side::Left);
        let (left, right) = (left.path.clone(), right.path.clone());
        let measure = PairMeasure {
            left,
            right,
            difference: both,
            body,
            is_exchanged,
        };
        (moves(ours) && moves(theirs)).then_some(measure)
    };
    let usable = scene.targets.par_iter().filter(|target| !target.suspect);
    usable
        .map_init(|| MirrorComparison::new(mirror), pair)
        .flatten()
        .collect()
}

/// Path of the target for the other side, if the file name says left.
fn right_of(path: &str) -> Option<String> {
    let (folder, file) = folder_and_name(path);
    let (stem, suffix) = file.split_once('.').unwrap_or((file, ""));
    let (_, right) = side::of_target(stem).filter(|(own, _)| *own == Side::Left)?;
    let file = format!("{right}.{suffix}");
    Some(if folder.is_empty() {
        file
    } else {
        format!("{folder}/{file}")
    })
}

/// Whether the middle of a mesh is near x = 0, by a tenth of its width.
fn is_centred(positions: &[Point]) -> bool {
    bounding_box(positions)
        .is_some_and(|(low, high)| (low[0] + high[0]).abs() < 0.2 * (high[0] - low[0]))
}

fn skeleton_measure(rig: &Rig, rest: &[Point], is_centred: bool) -> Option<SkeletonMeasure> {
    Some(SkeletonMeasure {
        path: rig.path.clone(),
        bones: bones(&rig.skeleton, rest)?,
        is_centred,
        received: rig.received.clone(),
    })
}
