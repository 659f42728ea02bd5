//! What the weights of each vertex come to, for the vertices that a file mentions: a small file
//! costs little beside a large mesh.

use crate::mhw::{BoneWeights, Pair};

/// Sums of the vertices that have entries and are in the mesh, by vertex.
#[derive(Debug)]
pub(super) struct Sums(Vec<VertexSum>);

/// The sum of a vertex.
#[derive(Debug)]
pub(super) struct VertexSum {
    pub(super) vertex: u32,
    /// Sum over all bones, float32 as in the loader.
    pub(super) sum: f32,
    /// Whether some entry of the vertex is at fault.
    pub(super) is_faulty: bool,
}

impl Sums {
    /// Those of all bones on a mesh of so many vertices.
    pub(super) fn of(bones: &[BoneWeights], vertices: usize) -> Self {
        let in_mesh = |pair: &Pair| {
            u32::try_from(pair.vertex)
                .ok()
                .filter(|vertex| (*vertex as usize) < vertices)
        };
        let pairs = bones.iter().flat_map(|bone| &bone.pairs);
        let mut pairs: Vec<(u32, f32)> = pairs
            .filter_map(|pair| Some((in_mesh(pair)?, pair.weight)))
            .collect();
        // Weights of one vertex stay in the order of the file, in which the loader adds them.
        pairs.sort_by_key(|(vertex, _)| *vertex);
        let mut sums: Vec<VertexSum> = Vec::new();
        for (vertex, weight) in pairs {
            if sums.last().is_none_or(|last| last.vertex != vertex) {
                sums.push(VertexSum {
                    vertex,
                    sum: 0.0,
                    is_faulty: false,
                });
            }
            if let Some(last) = sums.last_mut() {
                last.sum += weight;
            }
        }
        Self(sums)
    }

    /// All of them, ascending.
    pub(super) fn iter(&self) -> impl Iterator<Item = &VertexSum> {
        self.0.iter()
    }

    /// The sum of the vertex of a pair.
    pub(super) fn of_pair(&self, pair: &Pair) -> Option<f32> {
        self.0.get(self.place(pair)?).map(|sum| sum.sum)
    }

    /// Notes that an entry of a vertex is at fault.
    pub(super) fn mark_faulty(&mut self, pair: &Pair) {
        let sum = self.place(pair).and_then(|place| self.0.get_mut(place));
        if let Some(sum) = sum {
            sum.is_faulty = true;
        }
    }

    fn place(&self, pair: &Pair) -> Option<usize> {
        let vertex = u32::try_from(pair.vertex).ok()?;
        self.0.binary_search_by_key(&vertex, |sum| sum.vertex).ok()
    }
}
