//! Skeletons from files, and their joints and rest matrices on a mesh.

use std::path::Path;

use super::compose::skeleton_of;
use super::stopped;
use crate::Error;
use crate::data::{RestSkeleton, SkeletonFile};
use crate::files::{read_document, shown};
use mhlint_eval::vector::Point;
use mhlint_formats::mhskel::{self, Section};

/// Reads a `.mhskel`.
///
/// # Errors
/// A file that cannot be read or is no skeleton.
pub fn read_skeleton(path: &Path) -> Result<SkeletonFile, Error> {
    let document = read_document(path)?;
    let model = mhskel::read(&document);
    if model.bones_section != Section::Present {
        return Err(Error::file(shown(path), "`bones` is missing"));
    }
    Ok(SkeletonFile {
        path: shown(path),
        model,
    })
}

/// The same where joints are asked for as well: `MakeHuman` 2 does not do without.
///
/// # Errors
/// A file that cannot be read or is no skeleton.
pub fn read_skeleton_with_joints(path: &Path) -> Result<SkeletonFile, Error> {
    let skeleton = read_skeleton(path)?;
    skeleton.check_joints()?;
    Ok(skeleton)
}

impl SkeletonFile {
    /// # Errors
    /// No joints.
    fn check_joints(&self) -> Result<(), Error> {
        let has_joints = self.model.joints_section == Section::Present;
        if has_joints {
            Ok(())
        } else {
            Err(Error::file(&self.path, "`joints` is missing"))
        }
    }

    /// Name of the bone without parent.
    ///
    /// # Errors
    /// None or several.
    pub fn root(&self) -> Result<&str, Error> {
        let mut roots = self.model.bones.iter().filter(|bone| bone.parent.is_none());
        match (roots.next(), roots.next()) {
            (Some(root), None) => Ok(&root.name),
            (None, _) => Err(Error::file(
                &self.path,
                "every bone has a parent, so there is no root",
            )),
            (Some(_), Some(second)) => Err(Error::file(
                &self.path,
                format!("`{}` is a second bone without parent", second.name),
            )),
        }
    }
}

/// Joints and rest matrices on a mesh, or whatever makes the application refuse the skeleton for
/// it.
pub(crate) fn rest(file: &SkeletonFile, positions: &[Point]) -> Result<RestSkeleton, Error> {
    file.check_joints()?;
    let bound = skeleton_of(&file.model, positions.len());
    let skeleton = bound.map_err(|reason| Error::file(&file.path, reason))?;
    let joints = skeleton.joint_positions(positions).map_err(stopped)?;
    let bones = skeleton.rest_bones(&joints).map_err(stopped)?;
    Ok(RestSkeleton {
        skeleton,
        joints,
        bones,
    })
}
