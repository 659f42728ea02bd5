//! Weights of the base skeleton handed to another one through its reference bones.
//!
//! Gets the hierarchy of the base skeleton and, for each bone of the other one, its references as
//! numbers of base bones; returns the base bones whose weights it takes. Source:
//! `docs/loaders/makehuman1/skeletons.md#references-and-weights`.

use std::collections::BTreeMap;

use super::super::weights::{BoneWeights, Entry, merge_duplicates};

/// A bone of the other skeleton. Numbers are those of base bones; `None` stands for a name that the
/// base skeleton lacks: it gives nothing, but a list is not empty for it.
#[derive(Clone, Copy, Debug, Default)]
pub struct RemapBone<'a> {
    /// The base bone of the same name.
    pub same_name: Option<usize>,
    /// `weights_reference`, or without one `reference`.
    pub references: &'a [Option<usize>],
    /// Whether it is `weights_reference`: such a list is taken as it is.
    pub is_explicit: bool,
}

/// For each bone the base bones whose weights it takes, each once and in order.
///
/// What no list names below a base bone that one does goes to the bones with that list, at any
/// depth. Base bones are numbered with parents before children.
pub fn sources(parents: &[Option<usize>], bones: &[RemapBone<'_>]) -> Vec<Vec<usize>> {
    let Sources { mut own, free } = shared_sources(parents, bones);
    for Free { bones, takers } in &free {
        for taker in takers {
            if let Some(list) = own.get_mut(*taker) {
                list.extend(bones);
            }
        }
    }
    for list in &mut own {
        list.sort_unstable();
        list.dedup();
    }
    own
}

/// The same in little room: what several bones take is there once.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Sources {
    /// For each bone the base bones that it names, or without references that of its name; each
    /// once and in order.
    pub own: Vec<Vec<usize>>,
    /// What no list names; each base bone is in one of these at most.
    pub free: Vec<Free>,
}

/// Base bones that no list names.
#[derive(Debug, PartialEq, Eq)]
pub struct Free {
    /// Their numbers.
    pub bones: Vec<usize>,
    /// The bones that take all of them, each once and in order.
    pub takers: Vec<usize>,
}

/// As [`sources`]; grows with the bones and their references alone.
pub fn shared_sources(parents: &[Option<usize>], bones: &[RemapBone<'_>]) -> Sources {
    let mut own: Vec<Vec<usize>> = bones
        .iter()
        .map(|bone| bone.references.iter().flatten().copied().collect())
        .collect();
    for list in &mut own {
        list.sort_unstable();
        list.dedup();
    }
    let mut walk = Walk::new(parents, &own, bones);
    let mut free = Vec::new();
    for bone in (0..parents.len()).rev() {
        let bones = walk.pass(bone);
        let takers = walk.takers.get(bone).filter(|_| !bones.is_empty());
        free.extend(takers.cloned().map(|takers| Free { bones, takers }));
    }
    for (bone, list) in bones.iter().zip(&mut own) {
        if bone.references.is_empty() {
            list.extend(bone.same_name);
        }
    }
    Sources { own, free }
}

/// A walk over the base skeleton, from its leaves on.
struct Walk {
    children: Vec<Vec<usize>>,
    /// Whether some list names it.
    is_named: Vec<bool>,
    /// Bones that take what is free below it.
    takers: Vec<Vec<usize>>,
    /// Whether nobody names it, and it is a leaf or some bone directly below it is free.
    is_free: Vec<bool>,
    /// How many are free from it on downwards.
    free_below: Vec<usize>,
}

impl Walk {
    fn new(parents: &[Option<usize>], lists: &[Vec<usize>], bones: &[RemapBone<'_>]) -> Self {
        let count = parents.len();
        let mut walk = Self {
            children: vec![Vec::new(); count],
            is_named: vec![false; count],
            takers: vec![Vec::new(); count],
            is_free: vec![false; count],
            free_below: vec![0; count],
        };
        for (bone, parent) in parents.iter().enumerate() {
            if let Some(children) = parent.and_then(|parent| walk.children.get_mut(parent)) {
                children.push(bone);
            }
        }
        for (taker, (list, bone)) in lists.iter().zip(bones).enumerate() {
            for named in list {
                if let Some(is_named) = walk.is_named.get_mut(*named) {
                    *is_named = true;
                }
                if let Some(takers) = walk.takers.get_mut(*named).filter(|_| !bone.is_explicit) {
                    takers.push(taker);
                }
            }
        }
        walk
    }

    /// Passes a bone whose children were passed; gives the free ones below it if they have somebody
    /// to go to.
    fn pass(&mut self, bone: usize) -> Vec<usize> {
        let children = &self.children[bone];
        let has_free_child = children.iter().any(|child| self.is_free[*child]);
        let is_open = children.is_empty() || has_free_child;
        let mut found = Vec::new();
        if self.is_named[bone] && is_open && !self.takers[bone].is_empty() {
            self.take(bone, &mut found);
        }
        self.is_free[bone] = !self.is_named[bone] && is_open;
        let below: usize = self.children[bone]
            .iter()
            .map(|child| self.free_below[*child])
            .sum();
        self.free_below[bone] = below + usize::from(self.is_free[bone]);
        found
    }

    /// Takes all that is free below a bone; branches without any are not entered.
    fn take(&mut self, bone: usize, found: &mut Vec<usize>) {
        let mut open = vec![bone];
        while let Some(at) = open.pop() {
            open.extend(
                self.children[at]
                    .iter()
                    .filter(|child| self.free_below[**child] > 0),
            );
            if at != bone {
                self.free_below[at] = 0;
                if std::mem::take(&mut self.is_free[at]) {
                    self.is_named[at] = true;
                    found.push(at);
                }
            }
        }
    }
}

/// The weights that bones take, by number of the bone; those without any are left out.
pub fn taken(weights: &[BoneWeights], sources: &[Vec<usize>]) -> Vec<BoneWeights> {
    let lists: BTreeMap<usize, &[Entry]> = weights
        .iter()
        .map(|list| (list.bone, list.entries.as_slice()))
        .collect();
    let bones = sources.iter().enumerate().map(|(bone, sources)| {
        let mut entries: Vec<Entry> = sources
            .iter()
            .filter_map(|source| lists.get(source))
            .copied()
            .flatten()
            .copied()
            .collect();
        entries.sort_by_key(|(vertex, _)| *vertex);
        merge_duplicates(&mut entries);
        BoneWeights { bone, entries }
    });
    bones.filter(|list| !list.entries.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0 root, 1 arm below 0, 2 hand below 1, 3 finger below 2, 4 leg below 0, 5 foot below 4.
    const PARENTS: [Option<usize>; 6] = [None, Some(0), Some(1), Some(2), Some(0), Some(4)];

    fn refers(references: &[Option<usize>], is_explicit: bool) -> RemapBone<'_> {
        RemapBone {
            same_name: None,
            references,
            is_explicit,
        }
    }

    #[test]
    fn chains_that_nobody_names_go_to_the_bone_above() {
        let found = sources(
            &PARENTS,
            &[refers(&[Some(0)], false), refers(&[Some(1)], false)],
        );
        assert_eq!(found, [vec![0, 4, 5], vec![1, 2, 3]]);
    }

    #[test]
    fn a_named_bone_below_ends_the_chain() {
        // The hand has no free child: it is named by nobody and is not free, either.
        let found = sources(
            &PARENTS,
            &[refers(&[Some(1)], false), refers(&[Some(3)], false)],
        );
        assert_eq!(found, [vec![1], vec![3]]);
    }

    #[test]
    fn an_explicit_list_is_taken_as_it_is() {
        let found = sources(
            &PARENTS,
            &[refers(&[Some(0)], false), refers(&[Some(1)], true)],
        );
        // The arm has a free hand, but only through its own list; the root takes what is free below
        // it at any depth.
        assert_eq!(found, [vec![0, 2, 3, 4, 5], vec![1]]);
    }

    #[test]
    fn without_references_a_bone_has_its_namesake_and_names_nobody() {
        let named = RemapBone {
            same_name: Some(1),
            ..RemapBone::default()
        };
        let found = sources(&PARENTS, &[refers(&[Some(0)], false), named]);
        assert_eq!(found, [vec![0, 1, 2, 3, 4, 5], vec![1]]);
        let unknown = RemapBone {
            same_name: Some(1),
            references: &[None],
            is_explicit: true,
        };
        assert_eq!(sources(&PARENTS, &[unknown]), [Vec::<usize>::new()]);
    }

    #[test]
    fn several_that_name_one_bone_take_what_is_below_it() {
        let found = sources(
            &PARENTS,
            &[refers(&[Some(2)], false), refers(&[Some(2)], false)],
        );
        assert_eq!(found, [vec![2, 3], vec![2, 3]]);
        let shared = shared_sources(
            &PARENTS,
            &[refers(&[Some(2)], false), refers(&[Some(2)], false)],
        );
        let free = Free {
            bones: vec![3],
            takers: vec![0, 1],
        };
        assert_eq!(
            (shared.own, shared.free),
            (vec![vec![2], vec![2]], vec![free])
        );
    }

    #[test]
    fn what_is_taken_twice_is_added_up() {
        let list = |bone, entries: &[Entry]| BoneWeights {
            bone,
            entries: entries.to_vec(),
        };
        let weights = [list(0, &[(1, 0.5), (2, 1.0)]), list(1, &[(1, 0.25)])];
        let found = taken(&weights, &[vec![0, 1], vec![], vec![1]]);
        assert_eq!(
            found,
            [list(0, &[(1, 0.75), (2, 1.0)]), list(2, &[(1, 0.25)])]
        );
    }
}
