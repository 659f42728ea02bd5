//! Weights of the default skeleton handed to another one through the references of its bones
//! (`docs/loaders/makehuman2/skeletons.md#references`).

use std::collections::{BTreeMap, BTreeSet};

use super::compose::first_places;
use mhlint_eval::makehuman2::transfer::{Transfer, TransferBone, transfer};
use mhlint_eval::measures::Received;
use mhlint_eval::scene::Scene;
use mhlint_eval::skeleton::SceneSkeleton;
use mhlint_eval::weights::BoneWeights;
use mhlint_formats::mhskel::Skeleton;

/// What the bones of `skeleton` receive. `number` finds a default bone by name; `parents` are those
/// of the default bones.
pub(crate) fn through_references(
    weights: &[BoneWeights],
    parents: &[Option<usize>],
    skeleton: &Skeleton,
    number: impl Fn(&str) -> Option<usize>,
) -> Transfer {
    let numbers = |names: &Option<Vec<String>>| -> Vec<Option<usize>> {
        names.iter().flatten().map(|name| number(name)).collect()
    };
    let bones = skeleton.bones.iter();
    let lists: Vec<_> = bones
        .map(|bone| {
            (
                number(&bone.name),
                numbers(&bone.reference),
                numbers(&bone.weights_reference),
            )
        })
        .collect();
    let bones: Vec<TransferBone<'_>> = lists
        .iter()
        .map(|(same_name, reference, weights_reference)| TransferBone {
            same_name: *same_name,
            reference,
            weights_reference,
        })
        .collect();
    transfer(weights, parents, &bones)
}

/// Work on handing weights on that is done for one base: several hundred times that on hm08.
const MOST_WORK: usize = 1 << 26;
/// What a bone costs, whose name may be noted for each skeleton, compared with a weight.
const BONE: usize = 64;

/// The skeleton of a scene, ready to hand its weights on to one skeleton after the other.
pub(super) struct Giver<'s> {
    skeleton: &'s SceneSkeleton,
    weights: &'s [BoneWeights],
    numbers: BTreeMap<&'s str, usize>,
    parents: Vec<Option<usize>>,
    /// Vertices with weights.
    vertices: usize,
    /// For each vertex the number of the last skeleton that got something of it.
    taken: Vec<usize>,
    /// Skeletons so far.
    number: usize,
    left: usize,
    /// Whether there was too much work, and nothing is known of some skeletons.
    pub(super) is_cut: bool,
}

impl<'s> Giver<'s> {
    /// That of a scene, if it has one with weights.
    pub(super) fn of(scene: &'s Scene) -> Option<Self> {
        let (skeleton, weights) = scene.skeleton.as_ref().zip(scene.weights.as_ref())?;
        let mut giver = Self {
            skeleton,
            weights: &weights.bones,
            numbers: first_places(skeleton.names.iter().map(String::as_str)),
            parents: skeleton.bones.iter().map(|bone| bone.parent).collect(),
            vertices: 0,
            taken: vec![0; scene.positions.len()],
            number: 0,
            left: MOST_WORK,
            is_cut: false,
        };
        giver.vertices = giver.count(|_| true);
        Some(giver)
    }

    /// What another skeleton gets of the weights, and what is lost.
    pub(super) fn received(&mut self, skeleton: &Skeleton) -> Received {
        let entries = self
            .weights
            .iter()
            .map(|list| list.entries.len())
            .sum::<usize>();
        let left = self
            .left
            .checked_sub(entries.saturating_add(BONE * self.parents.len()));
        self.is_cut |= left.is_none();
        let Some(left) = left else {
            return Received::default();
        };
        self.left = left;
        let moved = through_references(self.weights, &self.parents, skeleton, |name| {
            self.numbers.get(name).copied()
        });
        // Who takes what is enough to know; what is taken, many times perhaps, is never put
        // together.
        let filled: BTreeSet<usize> = self
            .weights
            .iter()
            .filter(|list| !list.entries.is_empty())
            .map(|list| list.bone)
            .collect();
        let is_bare = |sources: &Vec<usize>| !sources.iter().any(|source| filled.contains(source));
        let bare = skeleton
            .bones
            .iter()
            .zip(&moved.sources)
            .filter(|(_, sources)| is_bare(sources));
        let taken: BTreeSet<usize> = moved.sources.iter().flatten().copied().collect();
        Received {
            without_weights: bare.map(|(bone, _)| bone.name.clone()).collect(),
            lost_bones: moved
                .lost
                .iter()
                .filter_map(|bone| self.skeleton.names.get(*bone).cloned())
                .collect(),
            lost_vertices: self.vertices - self.count(|bone| taken.contains(&bone)),
        }
    }

    /// Vertices that some of the bones have weights of.
    fn count(&mut self, is_counted: impl Fn(usize) -> bool) -> usize {
        self.number += 1;
        let mut count = 0;
        for (vertex, _) in self
            .weights
            .iter()
            .filter(|list| is_counted(list.bone))
            .flat_map(|list| &list.entries)
        {
            if let Some(last) = self
                .taken
                .get_mut(*vertex as usize)
                .filter(|last| **last != self.number)
            {
                *last = self.number;
                count += 1;
            }
        }
        count
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mhlint_eval::skeleton::Bone;
    use mhlint_eval::weights::LoadedWeights;

    #[test]
    fn skeletons_beyond_the_work_of_a_base_are_left_out() {
        let list = BoneWeights {
            bone: 0,
            entries: vec![(0, 1.0), (2, 1.0), (2, 0.5)],
        };
        let scene = Scene {
            positions: vec![[0.0; 3]; 3],
            skeleton: Some(SceneSkeleton {
                names: vec!["a".to_owned()],
                bones: vec![Bone {
                    parent: None,
                    head: 0,
                    tail: 0,
                    plane: None,
                }],
                ..SceneSkeleton::default()
            }),
            weights: Some(LoadedWeights {
                bones: vec![list],
                ..LoadedWeights::default()
            }),
            ..Scene::default()
        };
        let mut giver = Giver::of(&scene).unwrap();
        giver.left = 2 * (3 + BONE);
        for _ in 0..2 {
            let received = giver.received(&Skeleton::default());
            assert_eq!(
                (received.lost_bones, received.lost_vertices),
                (vec!["a".to_owned()], 2)
            );
        }
        assert!(!giver.is_cut);
        assert_eq!(giver.received(&Skeleton::default()), Received::default());
        assert!(giver.is_cut);
    }
}
