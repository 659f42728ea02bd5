//! Rules on `.mhskel`, and what they share: which skeletons count, and what becomes of a user of them.

pub(super) mod cycle;
pub(super) mod degenerate_plane;
pub(super) mod empty_joint;
mod hierarchy;
pub(super) mod joint_off_cube;
pub(super) mod joint_out_of_range;
mod lost;
pub(super) mod malformed_plane;
mod measured;
pub(super) mod missing_section;
pub(super) mod missing_weights;
pub(super) mod multiple_roots;
pub(super) mod name_asymmetry;
pub(super) mod name_clash;
pub(super) mod no_root;
pub(super) mod noisy_roll;
pub(super) mod swapped_ends;
pub(super) mod unclaimed_bones;
pub(super) mod unknown_joint;
pub(super) mod unknown_parent;
pub(super) mod unknown_plane;
pub(super) mod unknown_reference;
pub(super) mod unreachable_bone;
pub(super) mod unused_joint;
pub(super) mod unweighted_bone;
pub(super) mod wrong_side;
pub(super) mod zero_length_bone;

use std::collections::BTreeSet;

use crate::diag::{Case, Finding};
use crate::formats::mhskel::Skeleton;
use crate::repo::{self, Body, FileFacts};
use measured::plane_of;

/// More faults of one kind than this in a skeleton have one cause.
const SINGLE: usize = 3;

/// A skeleton that the application finds.
struct Rig<'a> {
    file: &'a FileFacts,
    skeleton: &'a Skeleton,
    own: &'a repo::Rig<'a>,
}

/// The skeletons of a body that the application finds and that are an object at all.
fn rigs<'v>(body: &Body<'v>) -> impl Iterator<Item = Rig<'v>> + use<'v> {
    let rig = |own: &'v repo::Rig<'v>| {
        let skeleton = own.skeleton().filter(|skeleton| skeleton.is_object)?;
        own.is_found.then_some(Rig { file: own.file, skeleton, own })
    };
    body.rigs.iter().filter_map(rig)
}

impl<'a> Rig<'a> {
    /// A finding on exceptions, with the time at which they reach the user.
    fn stops_with(&self, exceptions: Case, finding: Finding) -> Finding {
        let when = if self.own.is_default { "while loading the base mesh" } else { "when the skeleton is chosen" };
        exceptions.iter().fold(finding, |finding, (application, level, effect)| {
            finding.level_in(*application, *level).effect_in(*application, format!("{effect} {when}"))
        })
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
        self.skeleton.bones.iter().filter_map(plane_of).collect()
    }

    /// Bones that pose mode will look for because the weights mention them.
    fn weighted_bones(&self) -> BTreeSet<&'a str> {
        let weights = if self.own.is_default { self.own.weights() } else { None };
        let bones = weights.map(|weights| weights.bones.as_slice());
        let weighted = bones.unwrap_or_default().iter().filter(|bone| bone.listed > 0);
        weighted.map(|bone| bone.name.as_str()).collect()
    }
}
