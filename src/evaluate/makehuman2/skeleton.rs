//! Skeletons from files, and their joints and rest matrices on a mesh.

use std::path::Path;

use super::compose::skeleton_of;
use crate::eval::makehuman2::rest::hierarchy;
use crate::eval::skeleton::{RestBone, SceneSkeleton};
use crate::eval::vector::Point;
use crate::evaluate::Error;
use crate::evaluate::Evaluation;
use crate::evaluate::files::{read_document, shown};
use crate::formats::mhskel::{self, RotationPlane, Section, Skeleton};

/// A skeleton and where it came from.
#[derive(Debug, Clone)]
pub struct SkeletonFile {
    /// Its path.
    pub path: String,
    /// What is in it.
    pub model: Skeleton,
}

/// A skeleton on a mesh, parents before children.
#[derive(Debug, Clone)]
pub struct RestSkeleton {
    /// Its joints and bones by number.
    pub skeleton: SceneSkeleton,
    /// Positions of the joints, in mesh units.
    pub joints: Vec<Point>,
    /// The bones in rest pose.
    pub bones: Vec<RestBone>,
}

/// Reads a `.mhskel`.
///
/// # Errors
/// A file that cannot be read or is no skeleton.
pub fn read_skeleton(path: &Path) -> Result<SkeletonFile, Error> {
    let document = read_document(path)?;
    let model = mhskel::read(&document);
    if model.joints_section != Section::Present || model.bones_section != Section::Present {
        return Err(Error::file(shown(path), "a skeleton has `joints` and `bones`"));
    }
    Ok(SkeletonFile { path: shown(path), model })
}

impl SkeletonFile {
    /// Name of the bone without parent.
    ///
    /// # Errors
    /// None or several.
    pub fn root(&self) -> Result<&str, Error> {
        let mut roots = self.model.bones.iter().filter(|bone| bone.parent.is_none());
        match (roots.next(), roots.next()) {
            (Some(root), None) => Ok(&root.name),
            (None, _) => Err(Error::file(&self.path, "no bone is without parent")),
            (Some(_), Some(second)) => {
                Err(Error::file(&self.path, format!("`{}` is a second bone without parent", second.name)))
            }
        }
    }

    /// The skeleton by numbers, for a mesh of `vertices`.
    ///
    /// # Errors
    /// Whatever makes the application refuse it.
    pub fn bind(&self, vertices: usize) -> Result<SceneSkeleton, Error> {
        skeleton_of(&self.model, vertices).ok_or_else(|| Error::file(&self.path, refusal(&self.model, vertices)))
    }
}

impl Evaluation {
    /// The pose skeleton of the base.
    ///
    /// # Errors
    /// There is none, or it cannot be used.
    pub fn pose_skeleton(&self) -> Result<&SkeletonFile, Error> {
        let missing = |reason: &String| Error::NoSkeleton { base: self.base.clone(), reason: reason.clone() };
        self.skeleton.as_ref().map_err(missing)
    }
}

impl SkeletonFile {
    /// Joints and rest matrices on a mesh.
    ///
    /// # Errors
    /// A skeleton that the application refuses for this mesh.
    pub fn rest(&self, positions: &[Point]) -> Result<RestSkeleton, Error> {
        let skeleton = self.bind(positions.len())?;
        let joints = skeleton.joint_positions(positions)?;
        let bones = skeleton.rest_bones(&joints)?;
        Ok(RestSkeleton { skeleton, joints, bones })
    }
}

/// The first thing that makes the application refuse a skeleton.
fn refusal(skeleton: &Skeleton, vertices: usize) -> String {
    for joint in &skeleton.joints {
        let outside = |vertex: &&i64| usize::try_from(**vertex).map_or(true, |vertex| vertex >= vertices);
        if let Some(vertex) = joint.vertices.iter().flatten().find(outside) {
            return format!("joint `{}` names vertex {vertex}, the mesh has {vertices}", joint.name);
        }
    }
    let has_joint = |name: &str| {
        let mut joints = skeleton.joints.iter();
        joints.any(|joint| joint.name == name && joint.vertices.as_ref().is_some_and(|list| !list.is_empty()))
    };
    for bone in &skeleton.bones {
        for (end, joint) in [("head", &bone.head), ("tail", &bone.tail)] {
            match joint {
                Some(joint) if has_joint(joint) => {}
                Some(joint) => {
                    return format!("the {end} of bone `{}` is joint `{joint}`, which has no vertices", bone.name);
                }
                None => return format!("bone `{}` has no {end}", bone.name),
            }
        }
        if let Some(parent) = bone.parent.as_ref().filter(|parent| !skeleton.bones.iter().any(|b| b.name == **parent)) {
            return format!("the parent `{parent}` of bone `{}` does not exist", bone.name);
        }
        match &bone.rotation_plane {
            RotationPlane::Absent => {}
            RotationPlane::Malformed => return format!("`rotation_plane` of bone `{}` is no name", bone.name),
            RotationPlane::Named(name) => {
                let plane = skeleton.planes.iter().find(|plane| plane.name == *name);
                let joints = plane.and_then(|plane| plane.joints.as_deref()).unwrap_or_default();
                let known = joints.iter().take(3).filter(|joint| joint.as_deref().is_some_and(has_joint)).count();
                if known < 3 {
                    return format!("plane `{name}` of bone `{}` has no three joints", bone.name);
                }
            }
        }
    }
    let parent = |name: &Option<String>| {
        name.as_ref().and_then(|name| skeleton.bones.iter().position(|bone| bone.name == *name))
    };
    let parents: Vec<Option<usize>> = skeleton.bones.iter().map(|bone| parent(&bone.parent)).collect();
    hierarchy(&parents).map_or_else(|fault| fault.to_string(), |_| "it cannot be used".to_owned())
}
