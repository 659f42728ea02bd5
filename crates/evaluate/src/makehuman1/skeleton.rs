//! Skeletons of MakeHuman 1 on its mesh (`docs/loaders/makehuman1/skeletons.md#joints`).

use std::collections::BTreeMap;

use super::OWN;
use crate::Error;
use crate::data::{RestSkeleton, SkeletonFile};
use mhlint_eval::scene::Scene;
use mhlint_eval::skeleton::{Bone, Formulas, SceneSkeleton};
use mhlint_eval::vector::Point;
use mhlint_formats::mhskel::{Plane, RotationPlane, Skeleton};

/// Joints and rest matrices on a mesh, or whatever makes the application refuse the skeleton for
/// it.
pub(crate) fn rest(
    scene: &Scene,
    file: &SkeletonFile,
    positions: &[Point],
) -> Result<RestSkeleton, Error> {
    let skeleton =
        skeleton_of(&file.model, scene).map_err(|reason| Error::file(&file.path, reason))?;
    let stopped = |error| Error::index(OWN, error);
    let joints = skeleton.joint_positions(positions).map_err(stopped)?;
    let bones = skeleton.rest_bones(&joints).map_err(stopped)?;
    Ok(RestSkeleton {
        skeleton,
        joints,
        bones,
    })
}

/// The skeleton by numbers.
///
/// # Errors
/// A vertex that the mesh lacks, an end without a name; no root.
pub(crate) fn skeleton_of(model: &Skeleton, scene: &Scene) -> Result<SceneSkeleton, String> {
    let mut joints = Joints::of(model, scene)?;
    let order = model.breadth_first();
    if order.is_empty() {
        return Err("it has no root bone".to_owned());
    }
    let planes: BTreeMap<&str, &Plane> = model
        .planes
        .iter()
        .rev()
        .map(|plane| (plane.name.as_str(), plane))
        .collect();
    let mut bones = Vec::new();
    let mut names = Vec::new();
    for (place, parent) in order {
        let Some(bone) = model.bones.get(place) else {
            continue;
        };
        let mut end = |end: &str, name: &Option<String>| {
            let name = name.as_deref().filter(|name| !name.is_empty());
            name.map(|name| joints.number(name))
                .ok_or_else(|| format!("bone `{}` has no {end}", bone.name))
        };
        let (head, tail) = (end("head", &bone.head)?, end("tail", &bone.tail)?);
        let plane = match &bone.rotation_plane {
            RotationPlane::Named(name) => planes
                .get(name.as_str())
                .and_then(|plane| three(plane, &mut joints)),
            RotationPlane::Absent | RotationPlane::Malformed => None,
        };
        bones.push(Bone {
            parent,
            head,
            tail,
            plane,
        });
        names.push(bone.name.clone());
    }
    let formulas = Formulas::Makehuman1;
    Ok(SceneSkeleton {
        names,
        bones,
        joint_names: joints.names,
        joints: joints.vertices,
        formulas,
    })
}

fn three(plane: &Plane, joints: &mut Joints<'_>) -> Option<[usize; 3]> {
    match plane.joints.as_deref()? {
        [Some(a), Some(b), Some(c)] => Some([joints.number(a), joints.number(b), joints.number(c)]),
        _ => None,
    }
}

/// The joints that bones ask for: those of the skeleton, then groups of the mesh.
struct Joints<'s> {
    scene: &'s Scene,
    names: Vec<String>,
    vertices: Vec<Vec<u32>>,
    places: BTreeMap<String, usize>,
}

impl<'s> Joints<'s> {
    fn of(model: &Skeleton, scene: &'s Scene) -> Result<Self, String> {
        let mut joints = Self {
            scene,
            names: Vec::new(),
            vertices: Vec::new(),
            places: BTreeMap::new(),
        };
        let count = scene.positions.len();
        for joint in &model.joints {
            let Some(list) = joint.vertices.as_deref().filter(|list| !list.is_empty()) else {
                continue;
            };
            let outside = |vertex| {
                format!(
                    "joint `{}` uses vertex {vertex}, but the mesh has {count} vertices",
                    joint.name
                )
            };
            let vertices = list
                .iter()
                .map(|vertex| from_either_end(*vertex, count).ok_or_else(|| outside(*vertex)));
            let vertices = vertices.collect::<Result<_, _>>()?;
            joints.add(&joint.name, vertices);
        }
        Ok(joints)
    }

    fn add(&mut self, name: &str, vertices: Vec<u32>) -> usize {
        let place = self.names.len();
        self.names.push(name.to_owned());
        self.vertices.push(vertices);
        *self.places.entry(name.to_owned()).or_insert(place)
    }

    /// The place of a joint; one that is nowhere lies at the origin.
    fn number(&mut self, name: &str) -> usize {
        if let Some(place) = self.places.get(name) {
            return *place;
        }
        let vertices = group_vertices(self.scene, name);
        self.add(name, vertices)
    }
}

/// A number below 0 counts from the end.
fn from_either_end(vertex: i64, count: usize) -> Option<u32> {
    let count = i64::try_from(count).ok()?;
    let vertex = if vertex < 0 {
        vertex.checked_add(count)?
    } else {
        vertex
    };
    u32::try_from(vertex).ok().filter(|_| vertex < count)
}

/// The vertices of the group of a name, with or without `joint-` in front; none if there is no such
/// group.
fn group_vertices(scene: &Scene, name: &str) -> Vec<u32> {
    let long = if name.starts_with("joint-") {
        name.to_owned()
    } else {
        format!("joint-{name}")
    };
    let group = scene.groups.iter().position(|group| *group == long);
    let Some(group) = group.or_else(|| scene.groups.iter().position(|group| group == name)) else {
        return Vec::new();
    };
    let own = scene
        .faces()
        .zip(&scene.face_groups)
        .filter(|(_, of)| **of as usize == group);
    let mut vertices: Vec<u32> = own.flat_map(|(face, _)| face).copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(bones: &str) -> Skeleton {
        let text =
            format!(r#"{{"bones": {{{bones}}}, "joints": {{"a": [0], "b": [-1], "none": []}}}}"#);
        mhlint_formats::mhskel::read(&mhlint_json::parse(text.as_bytes()).unwrap())
    }

    fn scene() -> Scene {
        Scene {
            positions: vec![[0.0; 3], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0]],
            corners: vec![0, 1, 2],
            face_starts: vec![0, 3],
            face_groups: vec![0],
            groups: vec!["joint-eye".to_owned()],
            ..Scene::default()
        }
    }

    #[test]
    fn ends_are_joints_groups_or_the_origin() {
        let scene = scene();
        let skeleton = skeleton_of(
            &model(r#""r": {"head": "a", "tail": "b"}, "e": {"head": "eye", "tail": "none"}"#),
            &scene,
        );
        let skeleton = skeleton.unwrap();
        let joints = skeleton.joint_positions(&scene.positions).unwrap();
        let at = |bone: usize, head: bool| {
            joints[if head {
                skeleton.bones[bone].head
            } else {
                skeleton.bones[bone].tail
            }]
        };
        assert_eq!(
            [at(0, true), at(0, false), at(1, false)],
            [[0.0; 3], [0.0, 4.0, 0.0], [0.0; 3]]
        );
        assert!((at(1, true)[0] - 2.0 / 3.0).abs() < 1e-6);
        assert!(skeleton_of(&model(r#""r": {"head": "a"}"#), &scene).is_err());
        assert!(skeleton_of(&model(""), &scene).is_err());
    }
}
