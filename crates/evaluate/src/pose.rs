//! Poses from files, and the skinned base mesh.

use std::path::Path;

use super::error::Error;
use super::files::{read_document, shown};
use super::opened::Evaluation;
use mhlint_diag::nearest;
use mhlint_eval::skin::{Pose, PosedBone, pose_bones, skin};
use mhlint_eval::vector::{Mat4, Point, Vec3, transform, translation, widen};
use mhlint_json::Node;

/// A pose of some bones by name.
pub type Poses = Vec<(String, Pose)>;

/// A base mesh in a pose.
#[derive(Debug, Clone)]
pub struct PosedBase {
    /// Positions of the vertices.
    pub positions: Vec<Point>,
    /// The bones that were posed: name, head, tail, rest position to posed position.
    pub bones: Vec<(String, Vec3, Vec3, Mat4)>,
}

/// Reads a pose: an object of bone names, each with three rows of three numbers (rotation) or four
/// (rotation and translation), in global axes, relative to the rest pose. It may stand under
/// `poses`.
///
/// # Errors
/// A file that cannot be read, a bone whose matrix is none.
pub fn read_poses(path: &Path) -> Result<Poses, Error> {
    let document = read_document(path)?;
    let node = document.root.get("poses").unwrap_or(&document.root);
    poses(node).map_err(|reason| Error::file(shown(path), reason))
}

/// Poses from a JSON value.
pub(super) fn poses(node: &Node) -> Result<Poses, String> {
    if !node.is_object() {
        return Err("expected a pose as an object of bones and matrices".to_owned());
    }
    let members = node.effective_members().into_iter();
    members
        .map(|member| Ok((member.key.clone(), pose(&member.key, &member.node)?)))
        .collect()
}

fn pose(bone: &str, node: &Node) -> Result<Pose, String> {
    let fault = || format!("the pose of bone `{bone}` is not three rows of three or four numbers");
    let row = |node: &Node| -> Option<([f64; 3], f64)> {
        match node.elements() {
            [x, y, z] => Some(([x.as_f64()?, y.as_f64()?, z.as_f64()?], 0.0)),
            [x, y, z, t] => Some(([x.as_f64()?, y.as_f64()?, z.as_f64()?], t.as_f64()?)),
            _ => None,
        }
    };
    let [a, b, c] = node.elements() else {
        return Err(fault());
    };
    let (a, b, c) = row(a)
        .zip(row(b))
        .zip(row(c))
        .map(|((a, b), c)| (a, b, c))
        .ok_or_else(fault)?;
    Ok(Pose {
        rotation: [a.0, b.0, c.0],
        translation: [a.1, b.1, c.1],
    })
}

impl Evaluation {
    /// The base mesh, at `positions`, in a pose of its pose skeleton.
    ///
    /// # Errors
    /// No usable skeleton or weights, weights that stop the application, a bone that does not
    /// exist.
    pub fn posed(&self, positions: &[Point], poses: &Poses) -> Result<PosedBase, Error> {
        let rest = self.rest(self.pose_skeleton()?, positions)?;
        let stopped = |error| Error::index(self.application, error);
        if let Some(fault) = &self.weights_fault {
            return Err(fault.clone());
        }
        let no_weights = || Error::NoSkeleton {
            base: self.base.clone(),
            reason: "its pose skeleton has no usable weights file".to_owned(),
        };
        let weights = self.scene.weights.as_ref().ok_or_else(no_weights)?;
        let mut by_bone = vec![None; rest.bones.len()];
        let mut places = Vec::new();
        for (name, pose) in poses {
            let place = rest.skeleton.names.iter().position(|bone| bone == name);
            let place = place.ok_or_else(|| unknown_bone(name, &rest.skeleton.names))?;
            if let Some(slot) = by_bone.get_mut(place) {
                *slot = Some(*pose);
            }
            places.push(place);
        }
        let bones = pose_bones(&rest.skeleton.bones, &rest.bones, &by_bone).map_err(stopped)?;
        let moved: Vec<Mat4> = bones.iter().map(|bone| bone.moved).collect();
        let lists = self.posing_weights(&weights.bones, positions.len())?;
        let positions = skin(positions, &lists, &moved).map_err(stopped)?;
        let ends = |place: &usize| {
            let (bone, rest): (&PosedBone, _) = (bones.get(*place)?, rest.bones.get(*place)?);
            Some((
                translation(&bone.global),
                transform(&bone.moved, widen(rest.tail)),
                bone.moved,
            ))
        };
        let bones = poses.iter().zip(&places).filter_map(|((name, _), place)| {
            let (head, tail, moved) = ends(place)?;
            Some((name.clone(), head, tail, moved))
        });
        Ok(PosedBase {
            positions,
            bones: bones.collect(),
        })
    }
}

fn unknown_bone(name: &str, known: &[String]) -> Error {
    let nearest = nearest(name, known.iter().map(String::as_str)).map(str::to_owned);
    Error::UnknownBone {
        name: name.to_owned(),
        nearest,
    }
}
