//! Rules on `.mhskel`, and what they share: which skeletons count, and what becomes of a user of
//! them.

mod base_name;
mod cycle;
mod degenerate_plane;
mod empty_joint;
mod hierarchy;
mod joint_cubes;
mod joint_off_cube;
mod joint_or_group;
mod joint_out_of_range;
mod lost;
mod malformed_plane;
mod measured;
mod missing_section;
mod missing_weights;
mod mixed_references;
mod multiple_roots;
mod name_asymmetry;
mod name_clash;
mod no_root;
mod noisy_roll;
mod remapped;
mod shared_reference;
mod swapped_ends;
mod unclaimed_bones;
mod unknown_joint;
mod unknown_names;
mod unknown_parent;
mod unknown_plane;
mod unknown_reference;
mod unreachable_bone;
mod unused_joint;
mod unweighted_bone;
mod version;
mod wrong_side;
mod zero_length_bone;

use super::Rule;
use std::collections::BTreeSet;

/// The rules of the family.
pub(super) static RULES: &[&Rule] = &[
    &base_name::RULE,
    &cycle::RULE,
    &degenerate_plane::RULE,
    &empty_joint::RULE,
    &joint_off_cube::RULE,
    &joint_out_of_range::RULE,
    &malformed_plane::RULE,
    &missing_section::RULE,
    &missing_weights::RULE,
    &mixed_references::RULE,
    &shared_reference::RULE,
    &multiple_roots::RULE,
    &name_asymmetry::RULE,
    &name_clash::RULE,
    &no_root::RULE,
    &noisy_roll::RULE,
    &swapped_ends::RULE,
    &unclaimed_bones::RULE,
    &unknown_joint::RULE,
    &unknown_parent::RULE,
    &unknown_plane::RULE,
    &unknown_reference::RULE,
    &unreachable_bone::RULE,
    &unused_joint::RULE,
    &unweighted_bone::RULE,
    &version::RULE,
    &wrong_side::RULE,
    &zero_length_bone::RULE,
];

use measured::plane_of;
use mhlint_diag::{Case, Finding};
use mhlint_formats::mhskel::Skeleton;
use mhlint_repo::{self as repo, Body, FileFacts};

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
        own.is_found.then_some(Rig {
            file: own.file,
            skeleton,
            own,
        })
    };
    body.rigs.iter().filter_map(rig)
}

impl<'a> Rig<'a> {
    /// A finding on exceptions, with the time at which they reach the user.
    fn stops_with(&self, exceptions: Case, finding: Finding) -> Finding {
        let when = if self.own.is_default {
            "while loading the base mesh"
        } else {
            "when the skeleton is chosen"
        };
        exceptions
            .iter()
            .fold(finding, |finding, (application, level, effect)| {
                finding
                    .level_in(*application, *level)
                    .effect_in(*application, format!("{effect} {when}"))
            })
    }

    /// Joints that a bone, or a plane that a bone names, asks for.
    fn asked_joints(&self) -> BTreeSet<&'a str> {
        let bones = self.skeleton.bones.iter();
        let ends = bones
            .flat_map(|bone| [&bone.head, &bone.tail])
            .filter_map(Option::as_deref);
        let planes = self.asked_planes();
        let planes = self
            .skeleton
            .planes
            .iter()
            .filter(|plane| planes.contains(plane.name.as_str()));
        let corners = planes
            .flat_map(|plane| plane.joints.iter().flatten().take(3))
            .filter_map(Option::as_deref);
        ends.chain(corners).collect()
    }

    /// Planes that a bone names.
    fn asked_planes(&self) -> BTreeSet<&'a str> {
        self.skeleton.bones.iter().filter_map(plane_of).collect()
    }

    /// Bones that pose mode will look for because the weights mention them.
    fn weighted_bones(&self) -> BTreeSet<&'a str> {
        let weights = if self.own.is_default {
            self.own.weights()
        } else {
            None
        };
        let bones = weights.map(|weights| weights.bones.as_slice());
        let weighted = bones
            .unwrap_or_default()
            .iter()
            .filter(|bone| bone.listed > 0);
        weighted.map(|bone| bone.name.as_str()).collect()
    }
}
