//! Rules on `.mhskel`, and what they share: which skeletons count, and what becomes of a user of them.

pub(super) mod cycle;
pub(super) mod degenerate_plane;
pub(super) mod empty_joint;
mod hierarchy;
pub(super) mod joint_out_of_range;
mod lost;
pub(super) mod malformed_plane;
mod measured;
pub(super) mod missing_section;
pub(super) mod missing_weights;
pub(super) mod multiple_roots;
pub(super) mod name_asymmetry;
pub(super) mod no_root;
pub(super) mod noisy_roll;
pub(super) mod unknown_joint;
pub(super) mod unknown_parent;
pub(super) mod unknown_plane;
pub(super) mod unknown_reference;
pub(super) mod unreachable_bone;
pub(super) mod unused_joint;
pub(super) mod unweighted_bone;
pub(super) mod zero_length_bone;

use std::collections::BTreeSet;

use crate::formats::mhskel::{RotationPlane, Skeleton};
use crate::formats::mhw::Weights;
use crate::repo::{Base, FileFacts, Reference, ReferenceKind, Repository, Resolution};

/// A skeleton that the application finds.
struct Rig<'a> {
    file: &'a FileFacts,
    skeleton: &'a Skeleton,
    /// Whether the base loads it at start, for poses.
    is_pose: bool,
    /// The weights that it loads, if they could be read.
    weights: Option<&'a Weights>,
}

/// The skeletons of a base, without those in folders that are too deep to be found.
fn rigs<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Vec<Rig<'a>> {
    let pose = pose_skeleton(repository, base);
    let rig = |file: &&'a FileFacts| {
        let is_pose = pose.is_some_and(|pose| std::ptr::eq(pose, *file));
        let weights = bound_weights(repository, base, file);
        let skeleton = file.skeleton().filter(|skeleton| skeleton.is_object)?;
        (is_pose || is_scanned(file)).then_some(Rig { file, skeleton, is_pose, weights })
    };
    base.skeletons.iter().filter_map(rig).collect()
}

/// One folder below `rigs/<base>/` is scanned.
fn is_scanned(file: &FileFacts) -> bool {
    file.rel.split('/').count() <= 4
}

/// The skeleton that `base.json` names, if it is known.
fn pose_skeleton<'a>(repository: &Repository<'a>, base: &Base<'a>) -> Option<&'a FileFacts> {
    let found = |reference: &Reference<'a>| match (reference.kind, reference.resolution) {
        (ReferenceKind::PoseSkeleton, Resolution::Found(file)) => Some(file),
        _ => None,
    };
    repository.references_of(base).find_map(found)
}

fn bound_weights<'a>(repository: &Repository<'a>, base: &Base<'a>, file: &FileFacts) -> Option<&'a Weights> {
    let found = |reference: &Reference<'a>| match (reference.kind, reference.resolution) {
        (ReferenceKind::WeightsFile, Resolution::Found(weights)) if std::ptr::eq(reference.from, file) => {
            weights.weights()
        }
        _ => None,
    };
    repository.references_of(base).find_map(found)
}

impl<'a> Rig<'a> {
    /// When an exception in this skeleton reaches the user.
    fn stops_with(&self, error: &str) -> String {
        if self.is_pose {
            format!("stops with {error} while the base is loaded")
        } else {
            format!("stops with {error} when the skeleton is chosen")
        }
    }

    /// Joints that a bone, or a plane that a bone names, asks for.
    fn asked_joints(&self) -> BTreeSet<&'a str> {
        let bones = self.skeleton.bones.iter();
        let ends = bones.flat_map(|bone| [&bone.head, &bone.tail]).filter_map(Option::as_deref);
        let planes = self.asked_planes();
        let planes = self.skeleton.planes.iter().filter(|plane| planes.contains(plane.name.as_str()));
        let corners = planes.flat_map(|plane| plane.joints.iter().flatten().take(3)).filter_map(Option::as_deref);
        ends.chain(corners).collect()
    }

    /// Planes that a bone names.
    fn asked_planes(&self) -> BTreeSet<&'a str> {
        let bones = self.skeleton.bones.iter();
        bones
            .filter_map(|bone| {
                if let RotationPlane::Named(plane) = &bone.rotation_plane { Some(plane.as_str()) } else { None }
            })
            .collect()
    }

    /// Bones that pose mode will look for because the weights mention them.
    fn weighted_bones(&self) -> BTreeSet<&'a str> {
        let bones = self.weights.filter(|_| self.is_pose).map(|weights| weights.bones.as_slice());
        let weighted = bones.unwrap_or_default().iter().filter(|bone| bone.listed > 0);
        weighted.map(|bone| bone.name.as_str()).collect()
    }
}
