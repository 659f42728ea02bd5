//! What MakeHuman 1 adds to loading weights, and how it keeps the strongest bones of a vertex.
//!
//! Source: `docs/loaders/makehuman1/weights.md#strongest-bones`.

use super::super::error::EvalError;
use super::super::influences::{Influence, Influences};
use super::super::load;
use super::super::weights::{BoneWeights, Entry, LoadedWeights, merge_duplicates};

/// How many bones a vertex can be reduced to.
pub const LIMITS: [usize; 7] = [1, 2, 3, 4, 5, 6, 13];

/// As [`load::load`], where entries of one vertex in a bone are added up first.
///
/// # Errors
/// A vertex at or beyond `vertex_count`.
pub fn load(
    bones: &[(usize, &[Entry])],
    root: usize,
    vertex_count: usize,
) -> Result<LoadedWeights, EvalError> {
    let merged: Vec<(usize, Vec<Entry>)> = bones
        .iter()
        .map(|(bone, entries)| (*bone, merged(entries)))
        .collect();
    let lists: Vec<(usize, &[Entry])> = merged
        .iter()
        .map(|(bone, entries)| (*bone, entries.as_slice()))
        .collect();
    load::load(&lists, root, vertex_count)
}

fn merged(entries: &[Entry]) -> Vec<Entry> {
    let mut entries = entries.to_vec();
    entries.sort_by_key(|(vertex, _)| *vertex);
    merge_duplicates(&mut entries);
    entries
}

/// The `limit` strongest bones of every vertex, at most as many as any vertex has; of equal ones
/// the later bone first. Only where some were cut the rest is scaled to a sum of 1. Free places
/// stand for bone 0 with a weight of 0.
///
/// # Errors
/// A vertex at or beyond `vertex_count`.
pub fn strongest(
    bones: &[BoneWeights],
    limit: usize,
    vertex_count: usize,
) -> Result<Vec<Vec<Influence>>, EvalError> {
    let influences = Influences::new(bones, vertex_count)?;
    let places = influences
        .iter()
        .map(<[Influence]>::len)
        .max()
        .unwrap_or(0)
        .min(limit);
    let of = |influences: &[Influence]| {
        let mut kept = influences.to_vec();
        kept.sort_by(|one, other| other.1.total_cmp(&one.1).then(other.0.cmp(&one.0)));
        if kept.len() > places {
            kept.truncate(places);
            let sum: f32 = kept.iter().map(|(_, weight)| weight).sum();
            kept.iter_mut().for_each(|(_, weight)| *weight /= sum);
        }
        kept.resize(places, (0, 0.0));
        kept
    };
    Ok(influences.iter().map(of).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duplicates_are_added_up_before_the_threshold() {
        let loaded = load(
            &[(0, &[(0, 5e-5), (1, 1.0), (0, 6e-5)]), (1, &[(0, 0.99989)])],
            9,
            2,
        )
        .unwrap();
        assert_eq!(loaded.bones[0].entries.len(), 2);
        assert_eq!(loaded.bones[1].entries.len(), 1);
    }

    #[test]
    fn only_what_was_cut_is_scaled() {
        let list = |bone, entries: &[Entry]| BoneWeights {
            bone,
            entries: entries.to_vec(),
        };
        let bones = [
            list(0, &[(0, 0.25)]),
            list(1, &[(0, 0.25), (1, 0.5)]),
            list(2, &[(0, 0.5)]),
        ];
        let found = strongest(&bones, 2, 3).unwrap();
        assert_eq!(
            found[0].iter().map(|(bone, _)| *bone).collect::<Vec<_>>(),
            [2, 1]
        );
        assert!((found[0][0].1 - 2.0 / 3.0).abs() < 1e-6);
        assert_eq!(found[1], [(1, 0.5), (0, 0.0)]);
        assert_eq!(found[2], [(0, 0.0); 2]);
        assert_eq!(strongest(&bones, 13, 3).unwrap()[0].len(), 3);
        assert!(strongest(&bones, 2, 1).is_err());
    }
}
