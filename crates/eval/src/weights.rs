//! Vertex weights by bone.

/// A vertex and its weight.
pub type Entry = (u32, f32);

/// The weights of one bone; `bone` is the caller's number for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoneWeights {
    /// Number of the bone.
    pub bone: usize,
    /// Its vertices and weights.
    pub entries: Vec<Entry>,
}

/// Weights after loading.
#[derive(Clone, Debug, Default)]
pub struct LoadedWeights {
    /// Bones with a non-empty list in the file, in file order, sorted by vertex. A bone can have
    /// become empty. Last comes the root if it had to be created; the vertices it had to take are
    /// at the end of its list, unsorted.
    pub bones: Vec<BoneWeights>,
    /// For every vertex the sum of its weights in the file.
    pub raw_sums: Vec<f32>,
    /// For every vertex the share that fell to the threshold; nobody else gets it.
    pub lost: Vec<f32>,
    /// Vertices whose weights sum to 0: they belong to the root.
    pub root_vertices: Vec<u32>,
}

/// Adds up the entries of the same vertex; `entries` must be sorted by vertex.
pub fn merge_duplicates(entries: &mut Vec<Entry>) {
    entries.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 += next.1;
        }
        same
    });
}
