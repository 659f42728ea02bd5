//! Stored poses: read, set on a rig, and as JSON (`docs/loaders/mpfb/poses.md#stored-poses`).

use std::path::Path;

use serde_json::{Map, Value};

use super::rig::{StandingRig, rows, stops};
use crate::Error;
use crate::files::read_document;
use crate::outputs::{mesh_json, object, vector};
use mhlint_eval::mpfb::groups::VertexGroup;
use mhlint_eval::mpfb::pose::{BonePose, Turn, pose_matrices, rest_matrix, skinned};
use mhlint_eval::vector::{Mat4, Point, Vec3, inverse, multiply, transform, translation};
use mhlint_json::Node;

/// A stored pose.
#[derive(Debug, Clone, Default)]
pub struct StoredPose {
    turns: Vec<(String, Turn)>,
    moves: Vec<(String, Vec3)>,
    /// The spine and the width of the shoulders that the pose was made on; none where they are not
    /// to be scaled.
    original: Option<[Option<f64>; 2]>,
}

/// A rig in a pose.
#[derive(Debug, Clone)]
pub struct PosedRig {
    matrices: Vec<Mat4>,
    tails: Vec<Vec3>,
}

const ORDERS: [(&str, [usize; 3]); 6] = [
    ("XYZ", [0, 1, 2]),
    ("XZY", [0, 2, 1]),
    ("YXZ", [1, 0, 2]),
    ("YZX", [1, 2, 0]),
    ("ZXY", [2, 0, 1]),
    ("ZYX", [2, 1, 0]),
];

/// Reads a stored pose.
///
/// # Errors
/// A file that cannot be read, and what stops MPFB.
pub fn read_stored_pose(path: &Path) -> Result<StoredPose, Error> {
    stored_pose(&read_document(path)?.root)
}

/// A pose from a JSON value.
pub(super) fn stored_pose(node: &Node) -> Result<StoredPose, Error> {
    let lacks = |key: &str| stops("KeyError", format!("the pose has no `{key}`"));
    let kind = node
        .get("skeleton_type")
        .ok_or_else(|| lacks("skeleton_type"))?;
    let kind = kind
        .as_str()
        .ok_or_else(|| stops("TypeError", "`skeleton_type` is not a text".to_owned()))?;
    let mut pose = StoredPose::default();
    if kind.contains("default") {
        let size = |key| {
            node.get(key)
                .and_then(Node::as_f64)
                .filter(|size| *size > LEAST)
        };
        pose.original = Some([
            size("original_spine_length"),
            size("original_shoulder_width"),
        ]);
    }
    let modes = node.get("bone_rotation_modes");
    for member in node
        .get("bone_rotations")
        .ok_or_else(|| lacks("bone_rotations"))?
        .effective_members()
    {
        let mode = modes
            .and_then(|modes| modes.get(&member.key))
            .and_then(Node::as_str);
        pose.turns.push((
            member.key.clone(),
            turn(&member.key, &numbers(&member.key, &member.node)?, mode)?,
        ));
    }
    for member in node
        .get("bone_translations")
        .ok_or_else(|| lacks("bone_translations"))?
        .effective_members()
    {
        let [x, y, z, ..] = *numbers(&member.key, &member.node)? else {
            return Err(stops(
                "IndexError",
                format!(
                    "the translation of bone `{}` has fewer than 3 numbers",
                    member.key
                ),
            ));
        };
        pose.moves.push((member.key.clone(), [x, y, z]));
    }
    Ok(pose)
}

/// Smaller sizes are not scaled by.
const LEAST: f64 = 1e-4;

fn numbers(bone: &str, node: &Node) -> Result<Vec<f64>, Error> {
    let numbers: Option<Vec<f64>> = node.elements().iter().map(Node::as_f64).collect();
    let wrong = || {
        stops(
            "TypeError",
            format!("the pose of bone `{bone}` is not a list of numbers"),
        )
    };
    numbers.filter(|_| node.is_array()).ok_or_else(wrong)
}

fn turn(bone: &str, numbers: &[f64], mode: Option<&str>) -> Result<Turn, Error> {
    let usual = if numbers.len() == 4 {
        "QUATERNION"
    } else {
        "XYZ"
    };
    let mode = mode.unwrap_or(usual);
    let order = ORDERS
        .iter()
        .find(|(name, _)| *name == mode)
        .map(|(_, order)| *order);
    match (mode, order, numbers) {
        (_, Some(order), [x, y, z]) => Ok(Turn::Euler(order, [*x, *y, *z])),
        ("QUATERNION", _, [w, x, y, z]) => Ok(Turn::Quaternion([*w, *x, *y, *z])),
        ("AXIS_ANGLE", _, [angle, x, y, z]) => Ok(Turn::AxisAngle(*angle, [*x, *y, *z])),
        _ => Err(stops(
            "ValueError",
            format!(
                "{} numbers of bone `{bone}` do not fit `{mode}`",
                numbers.len()
            ),
        )),
    }
}

impl StandingRig {
    /// The rig in a pose. Bones that it does not have are passed over.
    ///
    /// # Errors
    /// A pose for the default rig, on one without its spine and shoulders.
    pub fn posed(&self, pose: &StoredPose) -> Result<PosedRig, Error> {
        let factors = self.factors(pose)?;
        let place = |name: &String| self.names.iter().position(|own| own == name);
        let still = BonePose {
            turn: Turn::Quaternion([1.0, 0.0, 0.0, 0.0]),
            translation: [0.0; 3],
        };
        let mut poses: Vec<Option<BonePose>> = vec![None; self.bones.len()];
        for (name, turn) in &pose.turns {
            if let Some(slot) = place(name).and_then(|at| poses.get_mut(at)) {
                *slot = Some(BonePose {
                    turn: *turn,
                    ..still
                });
            }
        }
        for (name, [x, y, z]) in &pose.moves {
            if let Some(slot) = place(name).and_then(|at| poses.get_mut(at)) {
                let translation = [x * factors[0], y * factors[1], z * factors[2]];
                *slot = Some(BonePose {
                    translation,
                    ..slot.unwrap_or(still)
                });
            }
        }
        let matrices = pose_matrices(&self.bones, &poses);
        let tail = |(bone, matrix): (&mhlint_eval::mpfb::rest::RestBone, &Mat4)| {
            transform(&multiply(matrix, &inverse(&rest_matrix(bone))), bone.tail)
        };
        let tails = self.bones.iter().zip(&matrices).map(tail).collect();
        Ok(PosedRig { matrices, tails })
    }

    /// What translations are multiplied by.
    fn factors(&self, pose: &StoredPose) -> Result<Vec3, Error> {
        let Some([spine, shoulders]) = pose.original else {
            return Ok([1.0; 3]);
        };
        let bone = |name: &str| {
            let at = self.names.iter().position(|own| own == name);
            let missing = || {
                stops(
                    "AttributeError",
                    format!("a pose for the default rig needs bone `{name}`"),
                )
            };
            at.and_then(|at| self.bones.get(at)).ok_or_else(missing)
        };
        let apart = |a: Vec3, b: Vec3| mhlint_eval::vector::length(mhlint_eval::vector::sub(a, b));
        let length = apart(bone("spine05")?.head, bone("spine01")?.tail);
        let width = apart(bone("shoulder01.L")?.tail, bone("shoulder01.R")?.tail);
        let factor =
            |own: f64, original: Option<f64>| original.map_or(1.0, |original| own / original);
        let across = factor(width, shoulders);
        Ok([across, across, factor(length, spine)])
    }

    /// The mesh moved by its groups, in a pose.
    pub fn skinned(
        &self,
        positions: &[Point],
        posed: &PosedRig,
        groups: &[VertexGroup],
    ) -> Vec<Point> {
        let mut weights: Vec<Vec<(usize, f64)>> = vec![Vec::new(); positions.len()];
        for (name, own) in groups {
            let Some(bone) = self.names.iter().position(|bone| bone == name) else {
                continue;
            };
            for (vertex, weight) in own {
                if let Some(list) = weights.get_mut(*vertex) {
                    list.push((bone, *weight));
                }
            }
        }
        skinned(positions, &self.bones, &posed.matrices, &weights)
    }

    /// Bones in a pose; those that are chosen, or all.
    pub(super) fn posed_json(&self, posed: &PosedRig, chosen: Option<&[String]>) -> Value {
        let bones = self.names.iter().zip(&posed.matrices).zip(&posed.tails);
        let bone = |((name, matrix), tail): ((&String, &Mat4), &Vec3)| {
            let fields = object([
                ("matrix", rows(matrix)),
                ("head", vector(translation(matrix))),
                ("tail", vector(*tail)),
            ]);
            (name.clone(), Value::Object(fields))
        };
        let is_chosen = |name: &String| chosen.is_none_or(|chosen| chosen.contains(name));
        Value::Object(
            bones
                .filter(|((name, _), _)| is_chosen(name))
                .map(bone)
                .collect(),
        )
    }

    /// As `mhlint eval skin` shows it.
    ///
    /// # Errors
    /// A chosen vertex that the mesh does not have.
    pub fn posed_outputs(
        &self,
        posed: &PosedRig,
        positions: &[Point],
        vertices: &[i64],
    ) -> Result<Map<String, Value>, Error> {
        let mut outputs = mesh_json(positions, vertices)?;
        outputs.insert("bones".to_owned(), self.posed_json(posed, None));
        Ok(outputs)
    }
}
