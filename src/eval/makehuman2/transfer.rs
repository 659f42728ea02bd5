//! Body weights moved to another skeleton through its reference bones.
//!
//! Gets the default skeleton's weights and hierarchy and, for each bone of the other skeleton, its references as
//! numbers of default bones; returns the weights of the other skeleton. Source: export to a rig that is not the default
//! (formats/makehuman2.md §10.2).

use super::super::weights::{BoneWeights, Entry, merge_duplicates};

/// A bone of the other skeleton. Numbers are those of default bones; leave out names that the default skeleton lacks,
/// the application ignores them.
#[derive(Clone, Copy, Debug, Default)]
pub struct TransferBone<'a> {
    /// The default bone of the same name.
    pub same_name: Option<usize>,
    /// `reference`.
    pub reference: &'a [usize],
    /// `weights_reference`.
    pub weights_reference: &'a [usize],
}

/// Outcome of a transfer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Transfer {
    /// For every bone of the other skeleton the default bones whose weights it takes.
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
/// A bone without `reference` whose name has default weights takes these, or its `weights_reference` instead if it
/// has any. Every other bone takes both lists together, a bone in both once. Default bones that nobody takes go to
/// all who take their nearest taken ancestor. Nothing is normalised: what two bones take counts twice.
pub fn transfer(weights: &[BoneWeights], parents: &[Option<usize>], bones: &[TransferBone]) -> Transfer {
    let mut entries: Vec<Option<&[Entry]>> = vec![None; parents.len()];
    for list in weights {
        if let Some(place) = entries.get_mut(list.bone) {
            *place = Some(&list.entries);
        }
    }
    let weighted = |bone: usize| entries.get(bone).is_some_and(Option::is_some);
    let mut sources: Vec<Vec<usize>> = bones.iter().map(|bone| own_sources(bone, weighted)).collect();
    let mut takers = vec![Vec::new(); parents.len()];
    for (taker, taken) in sources.iter().enumerate() {
        for default in taken {
            if let Some(list) = takers.get_mut(*default) {
                list.push(taker);
            }
        }
    }
    let mut lost = Vec::new();
    for bone in (0..parents.len()).filter(|b| weighted(*b)) {
        match nearest_taken(bone, parents, &takers) {
            Some(taken) if taken == bone => {}
            Some(taken) => takers[taken].iter().for_each(|taker| sources[*taker].push(bone)),
            None => lost.push(bone),
        }
    }
    let bones = sources.iter().enumerate().map(|(bone, taken)| BoneWeights { bone, entries: added(taken, &entries) });
    let bones = bones.filter(|b| !b.entries.is_empty()).collect();
    Transfer { sources, bones, lost }
}

fn own_sources(bone: &TransferBone, weighted: impl Fn(usize) -> bool) -> Vec<usize> {
    let own =
        bone.same_name.filter(|own| weighted(*own) && bone.reference.is_empty() && bone.weights_reference.is_empty());
    let mut sources: Vec<usize> = Vec::new();
    for default in own.iter().chain(bone.reference).chain(bone.weights_reference) {
        if !sources.contains(default) {
            sources.push(*default);
        }
    }
    sources
}

/// The bone itself or its nearest ancestor that somebody takes. Bounded, since a cycle has no end.
fn nearest_taken(bone: usize, parents: &[Option<usize>], takers: &[Vec<usize>]) -> Option<usize> {
    let mut ancestors = std::iter::successors(Some(bone), |b| parents.get(*b).copied().flatten()).take(parents.len());
    ancestors.find(|b| takers.get(*b).is_some_and(|list| !list.is_empty()))
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

    fn refers<'a>(reference: &'a [usize], weights_reference: &'a [usize]) -> TransferBone<'a> {
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
        let found = transfer(&weights(), &PARENTS, &[refers(&[1], &[])]);
        assert_eq!(found.lost, [0, 3]);
    }

    #[test]
    fn weight_references_replace_the_own_weights() {
        let bone = TransferBone { same_name: Some(1), reference: &[], weights_reference: &[3] };
        assert_eq!(transfer(&weights(), &PARENTS, &[named(0), bone]).sources[1], [3]);
    }

    #[test]
    fn both_lists_are_united() {
        assert_eq!(transfer(&weights(), &PARENTS, &[refers(&[1, 2], &[2, 3])]).sources[0], [1, 2, 3]);
        let same = TransferBone { same_name: Some(3), reference: &[1], weights_reference: &[] };
        assert_eq!(transfer(&weights(), &PARENTS, &[named(0), same]).sources[1], [1, 2]);
    }

    #[test]
    fn bone_claimed_twice_is_copied_to_both() {
        let found = transfer(&weights(), &PARENTS, &[named(0), refers(&[3], &[]), refers(&[3], &[])]);
        assert_eq!(found.bones[1].entries, found.bones[2].entries);
    }

    #[test]
    fn bones_without_weights_are_left_out() {
        let found = transfer(&weights()[..1], &PARENTS, &[named(0), named(2), refers(&[9], &[])]);
        assert_eq!(found.bones.len(), 1);
    }

    #[test]
    fn cycle_in_the_default_skeleton_ends() {
        assert_eq!(transfer(&weights(), &[Some(1), Some(0), Some(2), None], &[]).lost, [0, 1, 2, 3]);
    }
}
