//! Weights seen from the vertices: which bones move a vertex, and what is lost when only N of them
//! may.
//!
//! Gets weights per bone, returns them per vertex. Source of the reduction: MakeHuman 2, glTF
//! export (`docs/loaders/makehuman2/skeletons.md#references`).

use super::error::EvalError;
use super::lists::Lists;
use super::weights::{BoneWeights, Entry};

/// A bone (the caller's number) and its weight.
pub type Influence = (usize, f32);

/// Weights per vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Influences(Lists<Influence>);

impl Influences {
    /// Turns weights per bone around. Bones stay in their order; duplicates of a vertex within a
    /// bone stay apart, one after the other.
    ///
    /// # Errors
    /// A vertex at or beyond `vertex_count`.
    pub fn new(bones: &[BoneWeights], vertex_count: usize) -> Result<Self, EvalError> {
        let entry =
            |bone: usize| move |(vertex, weight): &Entry| (*vertex as usize, (bone, *weight));
        let pairs = bones
            .iter()
            .flat_map(|list| list.entries.iter().map(entry(list.bone)));
        let mut vertices = bones
            .iter()
            .flat_map(|list| &list.entries)
            .map(|(vertex, _)| *vertex);
        if let Some(outside) = vertices.find(|vertex| *vertex as usize >= vertex_count) {
            return Err(EvalError::vertex(outside, vertex_count));
        }
        Ok(Self(Lists::new(vertex_count, pairs)))
    }

    /// The bones of a vertex; empty outside the mesh.
    pub fn of(&self, vertex: u32) -> &[Influence] {
        self.0.of(vertex as usize)
    }

    /// All vertices in order.
    pub fn iter(&self) -> impl Iterator<Item = &[Influence]> {
        self.0.iter()
    }

    /// Keeps the `limit` largest weights of every vertex, largest first (equal ones in bone order),
    /// scaled to sum 1.
    ///
    /// Duplicates within a bone are added up first. Vertices whose kept weights sum to 0 are not
    /// scaled.
    pub fn reduce(&self, limit: usize) -> Reduction {
        let mut result = Reduction {
            influences: Self(Lists::new(0, std::iter::empty())),
            ..Reduction::default()
        };
        for (vertex, influences) in (0..).zip(self.iter()) {
            let mut merged = merged(influences);
            merged.sort_by(|a, b| b.1.total_cmp(&a.1));
            result.most = result.most.max(merged.len());
            let total = sum(&merged);
            let lost = sum(merged.get(limit..).unwrap_or_default()) / total;
            if merged.len() > limit {
                result.reduced.push((vertex, lost));
                merged.truncate(limit);
                if result.worst.is_none_or(|(_, worst)| lost > worst) {
                    result.worst = Some((vertex, lost));
                }
            }
            let kept = sum(&merged);
            let factor = if kept == 0.0 { 1.0 } else { 1.0 / kept };
            result
                .influences
                .0
                .push(merged.iter().map(|(bone, weight)| (*bone, weight * factor)));
        }
        result
    }
}

/// Outcome of `Influences::reduce`.
#[derive(Clone, Debug, Default)]
pub struct Reduction {
    /// The weights that are left.
    pub influences: Influences,
    /// Largest number of bones on a vertex before.
    pub most: usize,
    /// Vertices that lost bones, and the share of its weight that each lost (0..1).
    pub reduced: Vec<(u32, f32)>,
    /// Vertex that lost the largest share of its weight, and that share.
    pub worst: Option<(u32, f32)>,
}

fn merged(influences: &[Influence]) -> Vec<Influence> {
    let mut merged: Vec<Influence> = Vec::with_capacity(influences.len());
    for (bone, weight) in influences {
        match merged.last_mut() {
            Some((last, sum)) if last == bone => *sum += weight,
            _ => merged.push((*bone, *weight)),
        }
    }
    merged
}

fn sum(influences: &[Influence]) -> f32 {
    influences.iter().map(|i| i.1).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bones(lists: &[&[(u32, f32)]]) -> Vec<BoneWeights> {
        lists
            .iter()
            .enumerate()
            .map(|(bone, entries)| BoneWeights {
                bone,
                entries: entries.to_vec(),
            })
            .collect()
    }

    #[test]
    fn weights_turn_around() {
        let found = Influences::new(&bones(&[&[(0, 0.5), (2, 1.0)], &[(0, 0.5)]]), 3).unwrap();
        assert_eq!(found.of(0), [(0, 0.5), (1, 0.5)]);
        assert!(found.of(1).is_empty() && found.of(7).is_empty());
        assert_eq!(found.iter().map(<[_]>::len).collect::<Vec<_>>(), [2, 0, 1]);
    }

    #[test]
    fn largest_weights_are_kept_and_scaled() {
        let all = Influences::new(
            &bones(&[&[(0, 0.1)], &[(0, 0.6)], &[(0, 0.1)], &[(0, 0.2)]]),
            1,
        )
        .unwrap();
        let reduced = all.reduce(2);
        let kept: Vec<usize> = reduced.influences.of(0).iter().map(|i| i.0).collect();
        assert_eq!(kept, [1, 3]);
        assert!((reduced.influences.of(0)[0].1 - 0.75).abs() < 1e-6);
        assert_eq!((reduced.most, reduced.reduced.len()), (4, 1));
        assert!((reduced.worst.unwrap().1 - 0.2).abs() < 1e-6);
    }

    #[test]
    fn equal_weights_keep_bone_order() {
        let all = Influences::new(&bones(&[&[(0, 0.25)], &[(0, 0.25)], &[(0, 0.5)]]), 1).unwrap();
        assert_eq!(
            all.reduce(2)
                .influences
                .of(0)
                .iter()
                .map(|i| i.0)
                .collect::<Vec<_>>(),
            [2, 0]
        );
    }

    #[test]
    fn duplicates_count_as_one_influence() {
        let all = Influences::new(&bones(&[&[(0, 0.25), (0, 0.25)], &[(0, 0.5)]]), 1).unwrap();
        let reduced = all.reduce(4);
        assert_eq!(
            (reduced.most, reduced.reduced.len(), reduced.worst),
            (2, 0, None)
        );
        assert_eq!(reduced.influences.of(0), [(0, 0.5), (1, 0.5)]);
    }

    #[test]
    fn vertices_without_weight_stay_empty() {
        let all = Influences::new(&bones(&[&[(1, 0.0)]]), 3).unwrap();
        let reduced = all.reduce(4).influences;
        assert_eq!(reduced.iter().count(), 3);
        assert_eq!(reduced.of(1), [(0, 0.0)]);
    }

    #[test]
    fn vertex_outside_the_mesh_is_an_error() {
        assert_eq!(
            Influences::new(&bones(&[&[(3, 1.0)]]), 3),
            Err(EvalError::vertex(3, 3))
        );
    }
}
