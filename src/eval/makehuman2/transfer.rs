//! Body weights moved to another skeleton through its reference bones.
//!
//! Gets the default skeleton's weights and hierarchy and, for each bone of the other skeleton, its references as
//! numbers of default bones; returns the weights of the other skeleton. Source: export to a rig that is not the default
//! (formats/makehuman2.md §10.2).

use super::super::weights::{BoneWeights, Entry, merge_duplicates};

/// A bone of the other skeleton. Numbers are those of default bones; `None` stands for a name that the default skeleton
/// lacks: it gives nothing, but a list is not empty for it.
#[derive(Clone, Copy, Debug, Default)]
pub struct TransferBone<'a> {
    /// The default bone of the same name.
    pub same_name: Option<usize>,
    /// `reference`.
    pub reference: &'a [Option<usize>],
    /// `weights_reference`.
    pub weights_reference: &'a [Option<usize>],
}

/// Outcome of a transfer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transfer {
    /// For every bone of the other skeleton the default bones whose weights it takes, each as often as it takes them.
    pub sources: Vec<Vec<usize>>,
    /// Its weights, sorted by vertex, entries of one vertex added up; `bone` is its number in the other skeleton.
    /// Empty lists are left out.
    pub bones: Vec<BoneWeights>,
    /// Default bones with weights that nobody takes: their weights are lost.
    pub lost: Vec<usize>,
}

/// Moves `weights` (as loaded; `bone` is the number of the default bone) to the skeleton `bones`; `parents` is the
/// hierarchy of the default skeleton.
///
/// A bone claims the names in `weights_reference`, or without any its own, and those in `reference`; of several that
/// claim one default bone the last counts. What nobody claims goes to the claimant of the nearest claimed ancestor.
/// What a bone takes by itself is another question: a claimed bone that its claimant does not take is lost. Nothing is
/// normalised: what two bones take, or one bone twice, counts twice.
pub fn transfer(weights: &[BoneWeights], parents: &[Option<usize>], bones: &[TransferBone<'_>]) -> Transfer {
    let mut entries: Vec<Option<&[Entry]>> = vec![None; parents.len()];
    for list in weights {
        if let Some(place) = entries.get_mut(list.bone) {
            *place = Some(&list.entries);
        }
    }
    let weighted = |bone: usize| entries.get(bone).is_some_and(Option::is_some);
    let claimants = claimants(bones, parents.len());
    let mut sources: Vec<Vec<usize>> = bones.iter().map(|bone| own_sources(bone, weighted)).collect();
    for list in weights {
        if let Some(claimant) = heir(list.bone, parents, &claimants).and_then(|heir| sources.get_mut(heir)) {
            claimant.push(list.bone);
        }
    }
    let mut is_taken = vec![false; parents.len()];
    for bone in sources.iter().flatten() {
        if let Some(taken) = is_taken.get_mut(*bone) {
            *taken = true;
        }
    }
    let lost = is_taken.iter().enumerate().filter(|(bone, taken)| !**taken && weighted(*bone)).map(|(bone, _)| bone);
    let lost = lost.collect();
    let bones = sources.iter().enumerate().map(|(bone, taken)| BoneWeights { bone, entries: added(taken, &entries) });
    let bones = bones.filter(|b| !b.entries.is_empty()).collect();
    Transfer { sources, bones, lost }
}

/// For every default bone the one that claims it.
fn claimants(bones: &[TransferBone<'_>], default_bones: usize) -> Vec<Option<usize>> {
    let mut claimants = vec![None; default_bones];
    for (claimant, bone) in bones.iter().enumerate() {
        let own = bone.same_name.filter(|_| bone.weights_reference.is_empty());
        let listed = bone.weights_reference.iter().chain(bone.reference).flatten().copied();
        for claimed in own.into_iter().chain(listed) {
            if let Some(place) = claimants.get_mut(claimed) {
                *place = Some(claimant);
            }
        }
    }
    claimants
}

/// The default bones that a bone takes without anybody's orphans.
fn own_sources(bone: &TransferBone<'_>, weighted: impl Fn(usize) -> bool) -> Vec<usize> {
    let known = |list: &[Option<usize>]| -> Vec<usize> {
        list.iter().flatten().copied().filter(|bone| weighted(*bone)).collect()
    };
    let own = bone.same_name.filter(|own| weighted(*own) && bone.reference.is_empty());
    match own {
        Some(own) if bone.weights_reference.is_empty() => vec![own],
        Some(_) => known(bone.weights_reference),
        None => {
            let mut sources = known(bone.reference);
            for more in known(bone.weights_reference) {
                if !sources.contains(&more) {
                    sources.push(more);
                }
            }
            sources
        }
    }
}

/// Who gets the weights of a default bone that nobody claims: the claimant of its nearest claimed ancestor. Bounded,
/// since a cycle has no end.
fn heir(bone: usize, parents: &[Option<usize>], claimants: &[Option<usize>]) -> Option<usize> {
    let claimant = |bone: usize| claimants.get(bone).copied().flatten();
    let mut ancestors = std::iter::successors(Some(bone), |b| parents.get(*b).copied().flatten()).take(parents.len());
    let is_orphan = claimant(bone).is_none();
    ancestors.find_map(claimant).filter(|_| is_orphan)
}

fn added(sources: &[usize], entries: &[Option<&[Entry]>]) -> Vec<Entry> {
    let lists = sources.iter().filter_map(|bone| entries.get(*bone).copied().flatten());
    let mut all: Vec<Entry> = lists.flatten().copied().collect();
    all.sort_by_key(|(vertex, _)| *vertex);
    merge_duplicates(&mut all);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Default skeleton: 0 root, 1 arm below 0, 2 hand below 1, 3 leg below 0. Vertex number = bone number, 2 also
    /// holds half of vertex 1.
    const PARENTS: [Option<usize>; 4] = [None, Some(0), Some(1), Some(0)];

    fn weights() -> Vec<BoneWeights> {
        let lists = [vec![(0, 1.0)], vec![(1, 0.5)], vec![(1, 0.5), (2, 1.0)], vec![(3, 1.0)]];
        lists.into_iter().enumerate().map(|(bone, entries)| BoneWeights { bone, entries }).collect()
    }

    fn named(bone: usize) -> TransferBone<'static> {
        TransferBone { same_name: Some(bone), ..TransferBone::default() }
    }

    fn refers<'a>(reference: &'a [Option<usize>], weights_reference: &'a [Option<usize>]) -> TransferBone<'a> {
        TransferBone { same_name: None, reference, weights_reference }
    }

    #[test]
    fn same_skeleton_keeps_its_weights() {
        let same = transfer(&weights(), &PARENTS, &[named(0), named(1), named(2), named(3)]);
        assert_eq!(same.bones, weights());
        assert!(same.lost.is_empty());
    }

    #[test]
    fn unclaimed_bones_go_to_the_nearest_claimed_ancestor() {
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1)]);
        assert_eq!(found.sources, [vec![0, 3], vec![1, 2]]);
        assert_eq!(found.bones[1].entries, [(1, 1.0), (2, 1.0)]);
    }

    #[test]
    fn weights_without_claimed_ancestor_are_lost() {
        let found = transfer(&weights(), &PARENTS, &[refers(&[Some(1)], &[])]);
        assert_eq!(found.lost, [0, 3]);
    }

    #[test]
    fn weight_references_replace_the_own_weights() {
        let bone = TransferBone { same_name: Some(1), reference: &[], weights_reference: &[Some(3)] };
        assert_eq!(transfer(&weights(), &PARENTS, &[named(0), bone]).sources[1], [3]);
    }

    #[test]
    fn both_lists_are_united() {
        assert_eq!(
            transfer(&weights(), &PARENTS, &[refers(&[Some(1), Some(2)], &[Some(2), Some(3)])]).sources[0],
            [1, 2, 3]
        );
    }

    #[test]
    fn orphans_go_to_the_last_of_several_that_claim_their_ancestor() {
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1), refers(&[Some(1)], &[]), named(3)]);
        assert_eq!(found.sources, [vec![0], vec![1], vec![1, 2], vec![3]]);
    }

    #[test]
    fn a_bone_named_twice_counts_twice() {
        let twice = refers(&[Some(2), Some(2)], &[]);
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1), twice, named(3)]);
        assert_eq!(found.bones[2].entries, [(1, 1.0), (2, 2.0)]);
        let same = TransferBone { same_name: Some(2), reference: &[], weights_reference: &[Some(2), Some(2)] };
        assert_eq!(transfer(&weights(), &PARENTS, &[named(0), same]).sources[1], [2, 2]);
    }

    #[test]
    fn a_name_that_is_claimed_and_not_taken_is_lost() {
        let same = TransferBone { same_name: Some(3), reference: &[Some(1)], weights_reference: &[] };
        let found = transfer(&weights(), &PARENTS, &[named(0), same]);
        assert_eq!((found.sources[1].as_slice(), found.lost.as_slice()), ([1, 2].as_slice(), [3].as_slice()));
    }

    #[test]
    fn unknown_names_keep_a_list_from_being_empty() {
        let same = TransferBone { same_name: Some(3), reference: &[], weights_reference: &[None] };
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1), same]);
        assert_eq!(found.sources, [vec![0, 3], vec![1, 2], vec![]]);
    }

    #[test]
    fn bone_claimed_twice_is_copied_to_both() {
        let found = transfer(&weights(), &PARENTS, &[named(0), refers(&[Some(3)], &[]), refers(&[Some(3)], &[])]);
        assert_eq!(found.bones[1].entries, found.bones[2].entries);
    }

    #[test]
    fn bones_without_weights_are_left_out() {
        let found = transfer(&weights()[..1], &PARENTS, &[named(0), named(2), refers(&[Some(9)], &[])]);
        assert_eq!(found.bones.len(), 1);
    }

    #[test]
    fn cycle_in_the_default_skeleton_ends() {
        assert_eq!(transfer(&weights(), &[Some(1), Some(0), Some(2), None], &[]).lost, [0, 1, 2, 3]);
    }
}
