//! Vertex weights as MakeHuman holds them after loading, of either version.
//!
//! Gets (vertex, weight) lists per bone and the number of vertices; returns the lists normalised,
//! with what was lost on the way. Source: `docs/loaders/makehuman2/weights.md#loading-weights`,
//! `docs/loaders/makehuman1/weights.md#loading-weights`. All arithmetic in `f32`, as there.

use super::error::EvalError;
use super::weights::{BoneWeights, Entry, LoadedWeights};

/// A normalised weight counts only above this.
pub const WEIGHT_LIMIT: f32 = 1e-4;

/// Divides by the sum of each vertex, sorts, drops what is not above `WEIGHT_LIMIT`, gives vertices
/// with sum 0 to the bone `root`.
///
/// Duplicate vertices of a bone are kept as they are. Negative shares are dropped after they have
/// counted for the sum; weights that cancel become infinite and the vertex goes to the root as
/// well; NaN drops the vertex everywhere without going to the root.
///
/// # Errors
/// A vertex at or beyond `vertex_count`.
pub fn load(
    bones: &[(usize, &[Entry])],
    root: usize,
    vertex_count: usize,
) -> Result<LoadedWeights, EvalError> {
    let raw_sums = vertex_sums(bones.iter().map(|b| b.1), vertex_count)?;
    let mut lost = vec![0.0; vertex_count];
    let mut loaded: Vec<BoneWeights> = bones
        .iter()
        .filter(|(_, entries)| !entries.is_empty())
        .map(|(bone, entries)| BoneWeights {
            bone: *bone,
            entries: normalised(entries, &raw_sums, &mut lost),
        })
        .collect();
    let root_vertices: Vec<u32> = (0..)
        .zip(&raw_sums)
        .filter(|(_, sum)| **sum == 0.0)
        .map(|(v, _)| v)
        .collect();
    if !root_vertices.is_empty() {
        give_to_root(&mut loaded, root, &root_vertices);
    }
    Ok(LoadedWeights {
        bones: loaded,
        raw_sums,
        lost,
        root_vertices,
    })
}

/// Sum of the weights of every vertex over all lists.
///
/// # Errors
/// A vertex at or beyond `vertex_count`.
fn vertex_sums<'a>(
    lists: impl IntoIterator<Item = &'a [Entry]>,
    vertex_count: usize,
) -> Result<Vec<f32>, EvalError> {
    let mut sums = vec![0.0; vertex_count];
    for (vertex, weight) in lists.into_iter().flatten() {
        *sums
            .get_mut(*vertex as usize)
            .ok_or_else(|| EvalError::vertex(*vertex, vertex_count))? += weight;
    }
    Ok(sums)
}

/// Every vertex of `entries` lies within `sums` (checked by `vertex_sums`).
fn normalised(entries: &[Entry], sums: &[f32], lost: &mut [f32]) -> Vec<Entry> {
    let mut shares: Vec<Entry> = entries
        .iter()
        .map(|(v, w)| (*v, w / sums[*v as usize]))
        .collect();
    shares.sort_by_key(|(vertex, _)| *vertex);
    shares.retain(|(vertex, share)| {
        let kept = *share > WEIGHT_LIMIT;
        if !kept && share.is_finite() {
            lost[*vertex as usize] += share;
        }
        kept
    });
    shares
}

fn give_to_root(loaded: &mut Vec<BoneWeights>, root: usize, vertices: &[u32]) {
    let place = loaded
        .iter()
        .position(|b| b.bone == root)
        .unwrap_or_else(|| {
            loaded.push(BoneWeights {
                bone: root,
                entries: Vec::new(),
            });
            loaded.len() - 1
        });
    loaded[place]
        .entries
        .extend(vertices.iter().map(|v| (*v, 1.0)));
}

#[cfg(test)]
mod tests {
    use super::super::weights::merge_duplicates;
    use super::*;

    fn loaded(bones: &[(usize, &[Entry])], count: usize) -> LoadedWeights {
        load(bones, 9, count).unwrap()
    }

    fn entries(bones: &[(usize, &[Entry])], count: usize) -> Vec<(usize, Vec<Entry>)> {
        loaded(bones, count)
            .bones
            .into_iter()
            .map(|b| (b.bone, b.entries))
            .collect()
    }

    #[test]
    fn sums_become_one() {
        let found = entries(&[(0, &[(0, 2.0), (1, 0.1)]), (1, &[(1, 0.3), (0, 2.0)])], 2);
        assert_eq!(
            found,
            [
                (0, vec![(0, 0.5), (1, 0.25)]),
                (1, vec![(0, 0.5), (1, 0.75)])
            ]
        );
    }

    #[test]
    fn loading_twice_changes_nothing_above_the_threshold() {
        let once = loaded(&[(0, &[(0, 0.3), (1, 2.0)]), (1, &[(0, 0.1)])], 2);
        let lists: Vec<(usize, &[Entry])> = once
            .bones
            .iter()
            .map(|b| (b.bone, b.entries.as_slice()))
            .collect();
        assert_eq!(loaded(&lists, 2).bones, once.bones);
    }

    #[test]
    fn threshold_is_strict_and_not_made_up_for() {
        let at_limit = WEIGHT_LIMIT;
        let result = loaded(
            &[
                (0, &[(0, 1.0 - at_limit), (1, 1.0)]),
                (1, &[(0, at_limit), (1, 0.0002)]),
            ],
            2,
        );
        assert_eq!(result.bones[1].entries.len(), 1);
        assert!((result.lost[0] - at_limit).abs() < 1e-9 && result.lost[1] == 0.0);
        assert!(result.bones[0].entries[0].1 < 1.0);
    }

    #[test]
    fn unweighted_vertices_are_appended_to_the_root() {
        let found = entries(&[(9, &[(1, 1.0)]), (0, &[(3, 1.0)])], 4);
        assert_eq!(found[0], (9, vec![(1, 1.0), (0, 1.0), (2, 1.0)]));
        assert_eq!(entries(&[], 2), [(9, vec![(0, 1.0), (1, 1.0)])]);
    }

    #[test]
    fn empty_lists_vanish_but_emptied_ones_stay() {
        let found = entries(&[(0, &[]), (1, &[(0, 1e-5)]), (2, &[(0, 1.0)])], 1);
        assert_eq!(found[0], (1, vec![]));
        assert_eq!(found.len(), 2);
    }

    #[test]
    fn duplicates_are_kept_and_can_be_merged() {
        let mut found = entries(
            &[(0, &[(0, 0.25), (1, 1.0), (0, 0.25)]), (1, &[(0, 0.5)])],
            2,
        );
        assert_eq!(found[0].1, [(0, 0.25), (0, 0.25), (1, 1.0)]);
        merge_duplicates(&mut found[0].1);
        assert_eq!(found[0].1, [(0, 0.5), (1, 1.0)]);
    }

    #[test]
    fn negative_share_is_dropped_and_the_rest_exceeds_one() {
        let found = entries(&[(0, &[(0, 1.0)]), (1, &[(0, -0.25)])], 1);
        assert!((found[0].1[0].1 - 4.0 / 3.0).abs() < 1e-6);
        assert!(found[1].1.is_empty());
    }

    #[test]
    fn cancelling_weights_are_infinite_and_go_to_the_root() {
        let found = entries(&[(0, &[(0, 1.0)]), (1, &[(0, -1.0)])], 1);
        assert_eq!(found[0].1, [(0, f32::INFINITY)]);
        assert_eq!(found[2], (9, vec![(0, 1.0)]));
    }

    #[test]
    fn zero_weights_go_to_the_root() {
        assert_eq!(
            entries(&[(0, &[(0, 0.0)])], 1),
            [(0, vec![]), (9, vec![(0, 1.0)])]
        );
    }

    #[test]
    fn nan_loses_the_vertex_everywhere() {
        let found = entries(&[(0, &[(0, f32::NAN)]), (1, &[(0, 1.0)])], 1);
        assert_eq!(found, [(0, vec![]), (1, vec![])]);
    }

    #[test]
    fn single_tiny_weight_becomes_one() {
        assert_eq!(entries(&[(0, &[(0, 1e-6)])], 1), [(0, vec![(0, 1.0)])]);
    }

    #[test]
    fn vertex_outside_the_mesh_is_an_error() {
        assert_eq!(
            load(&[(0, &[(2, 1.0)])], 0, 2).unwrap_err(),
            EvalError::vertex(2, 2)
        );
    }
}
