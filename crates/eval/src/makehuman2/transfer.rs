//! Body weights moved to another skeleton through its reference bones.
//!
//! Gets the default skeleton's weights and hierarchy and, for each bone of the other skeleton, its
//! references as numbers of default bones; returns the weights of the other skeleton. Source:
//! export to a rig that is not the default (`docs/loaders/makehuman2/skeletons.md#references`).

use std::collections::{BTreeMap, BTreeSet};

use super::super::steps::step;
use super::super::weights::{BoneWeights, Entry, merge_duplicates};

/// A bone of the other skeleton. Numbers are those of default bones; `None` stands for a name that
/// the default skeleton lacks: it gives nothing, but a list is not empty for it.
#[derive(Clone, Copy, Debug, Default)]
pub struct TransferBone<'a> {
    /// The default bone of the same name.
    pub same_name: Option<usize>,
    /// `reference`.
    pub reference: &'a [Option<usize>],
    /// `weights_reference`.
    pub weights_reference: &'a [Option<usize>],
}

/// Who takes what.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transfer {
    /// For every bone of the other skeleton the default bones whose weights it takes, each as often
    /// as it takes them.
    pub sources: Vec<Vec<usize>>,
    /// Default bones with weights that nobody takes: their weights are lost.
    pub lost: Vec<usize>,
}

/// Moves `weights` (as loaded; `bone` is the number of the default bone) to the skeleton `bones`;
/// `parents` is the hierarchy of the default skeleton.
///
/// A bone claims the names in `weights_reference`, or without any its own, and those in
/// `reference`; of several that claim one default bone the last counts. What nobody claims goes to
/// the claimant of the nearest claimed ancestor. What a bone takes by itself is another question: a
/// claimed bone that its claimant does not take is lost. Nothing is normalised: what two bones
/// take, or one bone twice, counts twice.
pub fn transfer(
    weights: &[BoneWeights],
    parents: &[Option<usize>],
    bones: &[TransferBone<'_>],
) -> Transfer {
    let entries = by_bone(weights);
    let weighted = |bone: usize| entries.contains_key(&bone);
    let claimants = claimants(bones, parents.len());
    let mut sources: Vec<Vec<usize>> = bones
        .iter()
        .map(|bone| own_sources(bone, weighted))
        .collect();
    let heirs = heirs(parents, &claimants);
    for list in weights
        .iter()
        .filter(|list| claimants.get(list.bone).is_some_and(Option::is_none))
    {
        let heir = heirs.get(list.bone).copied().flatten();
        if let Some(heir) = heir.and_then(|heir| sources.get_mut(heir)) {
            heir.push(list.bone);
        }
    }
    let mut is_taken = vec![false; parents.len()];
    for bone in sources.iter().flatten() {
        if let Some(taken) = is_taken.get_mut(*bone) {
            *taken = true;
        }
    }
    let lost = is_taken
        .iter()
        .enumerate()
        .filter(|(bone, taken)| !**taken && weighted(*bone))
        .map(|(bone, _)| bone);
    let lost = lost.collect();
    Transfer { sources, lost }
}

impl Transfer {
    /// How many entries of `weights` are handed on, those that several bones take as often as they
    /// are taken.
    pub fn entries_taken(&self, weights: &[BoneWeights]) -> usize {
        let entries = by_bone(weights);
        let length = |bone: &usize| entries.get(bone).map_or(0, |list| list.len());
        self.sources
            .iter()
            .flatten()
            .map(length)
            .fold(0, usize::saturating_add)
    }

    /// The weights of the bones of the other skeleton, sorted by vertex, entries of one vertex
    /// added up; `bone` is its number in the other skeleton. Empty lists are left out.
    pub fn taken(&self, weights: &[BoneWeights]) -> Vec<BoneWeights> {
        let entries = by_bone(weights);
        let sources = self.sources.iter().enumerate();
        let bones = sources.map(|(bone, taken)| BoneWeights {
            bone,
            entries: added(taken, &entries),
        });
        bones.filter(|bone| !bone.entries.is_empty()).collect()
    }
}

/// The entries of each default bone; of several lists for one the last.
fn by_bone(weights: &[BoneWeights]) -> BTreeMap<usize, &[Entry]> {
    weights
        .iter()
        .map(|list| (list.bone, list.entries.as_slice()))
        .collect()
}

/// For every default bone the one that claims it.
fn claimants(bones: &[TransferBone<'_>], default_bones: usize) -> Vec<Option<usize>> {
    let mut claimants = vec![None; default_bones];
    for (claimant, bone) in bones.iter().enumerate() {
        let own = bone.same_name.filter(|_| bone.weights_reference.is_empty());
        let listed = bone
            .weights_reference
            .iter()
            .chain(bone.reference)
            .flatten()
            .copied();
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
        list.iter()
            .flatten()
            .copied()
            .filter(|bone| weighted(*bone))
            .collect()
    };
    let own = bone
        .same_name
        .filter(|own| weighted(*own) && bone.reference.is_empty());
    match own {
        Some(own) if bone.weights_reference.is_empty() => vec![own],
        Some(_) => known(bone.weights_reference),
        None => {
            let mut sources = known(bone.reference);
            let mut there: BTreeSet<usize> = sources.iter().copied().collect();
            sources.extend(
                known(bone.weights_reference)
                    .into_iter()
                    .filter(|more| there.insert(*more)),
            );
            sources
        }
    }
}

/// For every default bone the claimant of itself, or else of its nearest claimed ancestor. Every
/// bone is walked over once, so that long chains cost what they hold and circles end.
fn heirs(parents: &[Option<usize>], claimants: &[Option<usize>]) -> Vec<Option<usize>> {
    let mut heirs = claimants.to_vec();
    let mut is_known: Vec<bool> = claimants.iter().map(Option::is_some).collect();
    for start in 0..parents.len() {
        let mut path = Vec::new();
        let mut at = Some(start);
        while let Some(bone) = at.filter(|bone| is_known.get(*bone) == Some(&false)) {
            step();
            is_known[bone] = true;
            path.push(bone);
            at = parents.get(bone).copied().flatten();
        }
        let heir = at.and_then(|bone| heirs.get(bone).copied().flatten());
        path.into_iter().for_each(|bone| heirs[bone] = heir);
    }
    heirs
}

fn added(sources: &[usize], entries: &BTreeMap<usize, &[Entry]>) -> Vec<Entry> {
    let lists = sources.iter().filter_map(|bone| entries.get(bone));
    let mut all: Vec<Entry> = lists.copied().flatten().copied().collect();
    all.sort_by_key(|(vertex, _)| *vertex);
    merge_duplicates(&mut all);
    all
}

#[cfg(test)]
mod tests {
    use super::super::super::steps::steps_of;
    use super::*;

    /// Default skeleton: 0 root, 1 arm below 0, 2 hand below 1, 3 leg below 0. Vertex number = bone
    /// number, 2 also holds half of vertex 1.
    const PARENTS: [Option<usize>; 4] = [None, Some(0), Some(1), Some(0)];

    fn weights() -> Vec<BoneWeights> {
        let lists = [
            vec![(0, 1.0)],
            vec![(1, 0.5)],
            vec![(1, 0.5), (2, 1.0)],
            vec![(3, 1.0)],
        ];
        lists
            .into_iter()
            .enumerate()
            .map(|(bone, entries)| BoneWeights { bone, entries })
            .collect()
    }

    fn named(bone: usize) -> TransferBone<'static> {
        TransferBone {
            same_name: Some(bone),
            ..TransferBone::default()
        }
    }

    fn refers<'a>(
        reference: &'a [Option<usize>],
        weights_reference: &'a [Option<usize>],
    ) -> TransferBone<'a> {
        TransferBone {
            same_name: None,
            reference,
            weights_reference,
        }
    }

    #[test]
    fn same_skeleton_keeps_its_weights() {
        let same = transfer(
            &weights(),
            &PARENTS,
            &[named(0), named(1), named(2), named(3)],
        );
        assert_eq!(same.taken(&weights()), weights());
        assert!(same.lost.is_empty());
    }

    #[test]
    fn a_chain_is_walked_once_and_a_circle_ends() {
        let count = 10_000;
        let chain: Vec<Option<usize>> = (0..count).map(|bone: usize| bone.checked_sub(1)).collect();
        let steps = steps_of(|| assert_eq!(heirs(&chain, &vec![None; count]), vec![None; count]));
        assert!(steps <= count as u64, "{steps}");
        assert_eq!(
            heirs(&[Some(1), Some(0), Some(0), None], &[None; 4]),
            [None; 4]
        );
        assert_eq!(
            heirs(
                &[Some(1), Some(2), None, Some(0)],
                &[None, None, Some(7), None]
            ),
            [Some(7); 4]
        );
    }

    #[test]
    fn unclaimed_bones_go_to_the_nearest_claimed_ancestor() {
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1)]);
        assert_eq!(found.sources, [vec![0, 3], vec![1, 2]]);
        assert_eq!(found.taken(&weights())[1].entries, [(1, 1.0), (2, 1.0)]);
    }

    #[test]
    fn weights_without_claimed_ancestor_are_lost() {
        let found = transfer(&weights(), &PARENTS, &[refers(&[Some(1)], &[])]);
        assert_eq!(found.lost, [0, 3]);
    }

    #[test]
    fn weight_references_replace_the_own_weights() {
        let bone = TransferBone {
            same_name: Some(1),
            reference: &[],
            weights_reference: &[Some(3)],
        };
        assert_eq!(
            transfer(&weights(), &PARENTS, &[named(0), bone]).sources[1],
            [3]
        );
    }

    #[test]
    fn both_lists_are_united() {
        assert_eq!(
            transfer(
                &weights(),
                &PARENTS,
                &[refers(&[Some(1), Some(2)], &[Some(2), Some(3)])]
            )
            .sources[0],
            [1, 2, 3]
        );
    }

    #[test]
    fn orphans_go_to_the_last_of_several_that_claim_their_ancestor() {
        let found = transfer(
            &weights(),
            &PARENTS,
            &[named(0), named(1), refers(&[Some(1)], &[]), named(3)],
        );
        assert_eq!(found.sources, [vec![0], vec![1], vec![1, 2], vec![3]]);
    }

    #[test]
    fn a_bone_named_twice_counts_twice() {
        let twice = refers(&[Some(2), Some(2)], &[]);
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1), twice, named(3)]);
        assert_eq!(found.taken(&weights())[2].entries, [(1, 1.0), (2, 2.0)]);
        let same = TransferBone {
            same_name: Some(2),
            reference: &[],
            weights_reference: &[Some(2), Some(2)],
        };
        assert_eq!(
            transfer(&weights(), &PARENTS, &[named(0), same]).sources[1],
            [2, 2]
        );
    }

    #[test]
    fn a_name_that_is_claimed_and_not_taken_is_lost() {
        let same = TransferBone {
            same_name: Some(3),
            reference: &[Some(1)],
            weights_reference: &[],
        };
        let found = transfer(&weights(), &PARENTS, &[named(0), same]);
        assert_eq!(
            (found.sources[1].as_slice(), found.lost.as_slice()),
            ([1, 2].as_slice(), [3].as_slice())
        );
    }

    #[test]
    fn unknown_names_keep_a_list_from_being_empty() {
        let same = TransferBone {
            same_name: Some(3),
            reference: &[],
            weights_reference: &[None],
        };
        let found = transfer(&weights(), &PARENTS, &[named(0), named(1), same]);
        assert_eq!(found.sources, [vec![0, 3], vec![1, 2], vec![]]);
    }

    #[test]
    fn bone_claimed_twice_is_copied_to_both() {
        let found = transfer(
            &weights(),
            &PARENTS,
            &[named(0), refers(&[Some(3)], &[]), refers(&[Some(3)], &[])],
        );
        assert_eq!(
            found.taken(&weights())[1].entries,
            found.taken(&weights())[2].entries
        );
    }

    #[test]
    fn bones_without_weights_are_left_out() {
        let found = transfer(
            &weights()[..1],
            &PARENTS,
            &[named(0), named(2), refers(&[Some(9)], &[])],
        );
        assert_eq!(found.taken(&weights()).len(), 1);
    }

    #[test]
    fn cycle_in_the_default_skeleton_ends() {
        assert_eq!(
            transfer(&weights(), &[Some(1), Some(0), Some(2), None], &[]).lost,
            [0, 1, 2, 3]
        );
    }
}
