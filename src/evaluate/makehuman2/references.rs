//! Weights of the default skeleton handed to another one through the references of its bones (formats/makehuman2.md
//! §10.2).

use crate::eval::makehuman2::transfer::{Transfer, TransferBone, transfer};
use crate::eval::weights::BoneWeights;
use crate::formats::mhskel::Skeleton;

/// What the bones of `skeleton` receive. `number` finds a default bone by name; `parents` are those of the default bones.
pub(in crate::evaluate) fn through_references(
    weights: &[BoneWeights],
    parents: &[Option<usize>],
    skeleton: &Skeleton,
    number: impl Fn(&str) -> Option<usize>,
) -> Transfer {
    let numbers = |names: &Option<Vec<String>>| -> Vec<usize> {
        names.iter().flatten().filter_map(|name| number(name)).collect()
    };
    let bones = skeleton.bones.iter();
    let lists: Vec<_> =
        bones.map(|bone| (number(&bone.name), numbers(&bone.reference), numbers(&bone.weights_reference))).collect();
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
