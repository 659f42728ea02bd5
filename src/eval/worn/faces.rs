//! Faces of any number of corners over shared vertices.

/// Faces as two flat lists.
#[derive(Debug, Clone, Copy, Default)]
pub struct Faces<'a> {
    /// Vertices of all faces, one after the other.
    pub corners: &'a [u32],
    /// Where each face begins in `corners`, and one entry for the end.
    pub starts: &'a [u32],
}

impl<'a> Faces<'a> {
    /// Those whose vertices are all below `count`.
    pub(super) fn below(self, count: usize) -> impl Iterator<Item = &'a [u32]> + Clone {
        let run = move |ends: &[u32]| match ends {
            [start, end] => self.corners.get(*start as usize..*end as usize),
            _ => None,
        };
        let is_whole = move |face: &&[u32]| face.len() >= 3 && face.iter().all(|vertex| (*vertex as usize) < count);
        self.starts.windows(2).filter_map(run).filter(is_whole)
    }

    /// The edges of these faces, each once, the smaller vertex first, in order, and those that more than two faces have.
    pub(super) fn edges(self, count: usize) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
        let mut edges = Vec::new();
        for face in self.below(count) {
            for (one, other) in face.iter().zip(face.iter().cycle().skip(1)).filter(|(one, other)| one != other) {
                edges.push([*one.min(other), *one.max(other)]);
            }
        }
        edges.sort_unstable();
        let crowded = edges.chunk_by(|one, other| one == other).filter(|run| run.len() > 2);
        let crowded = crowded.filter_map(|run| run.first().copied()).collect();
        edges.dedup();
        (edges, crowded)
    }
}

/// The triangles of a face, a fan around its first corner.
pub(super) fn fan(face: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    let first = face.first().copied().unwrap_or_default();
    face.windows(2).skip(1).map(move |pair| [first, pair[0], pair[1]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_told_once_and_foreign_faces_left_out() {
        let faces = Faces { corners: &[0, 1, 2, 3, 2, 1, 4, 0, 1, 9], starts: &[0, 4, 7, 10] };
        let all = vec![[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]];
        assert_eq!(faces.edges(5), (all, Vec::new()));
        let fins = Faces { corners: &[0, 1, 2, 1, 0, 3, 0, 1, 4], starts: &[0, 3, 6, 9] };
        assert_eq!(fins.edges(5).1, [[0, 1]]);
        assert_eq!(faces.below(5).count(), 2);
        assert_eq!(fan(&[5, 6, 7, 8]).collect::<Vec<_>>(), [[5, 6, 7], [5, 7, 8]]);
    }
}
