//! Faces of any number of corners over shared vertices.

use super::vector::{Point, Vec3, add, cross, scale, sub, widen};

/// Faces as two flat lists.
#[derive(Debug, Clone, Copy, Default)]
pub struct Faces<'a> {
    /// Vertices of all faces, one after the other.
    pub corners: &'a [u32],
    /// Where each face begins in `corners`, and one entry for the end.
    pub starts: &'a [u32],
}

impl<'a> Faces<'a> {
    /// How many there are.
    pub(super) fn count(self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Vertices of a face.
    pub(super) fn face(self, face: usize) -> &'a [u32] {
        let ends = self.starts.get(face).zip(self.starts.get(face + 1));
        ends.and_then(|(start, end)| self.corners.get(*start as usize..*end as usize))
            .unwrap_or_default()
    }

    /// All in order.
    pub(super) fn all(self) -> impl Iterator<Item = &'a [u32]> + Clone {
        (0..self.count()).map(move |face| self.face(face))
    }

    /// Those with an area whose vertices are all below `count`.
    pub(super) fn below(self, count: usize) -> impl Iterator<Item = &'a [u32]> + Clone {
        let is_whole = move |face: &&[u32]| {
            face.len() >= 3 && face.iter().all(|vertex| (*vertex as usize) < count)
        };
        self.all().filter(is_whole)
    }

    /// The edges of these faces, each once, the smaller vertex first, in order, and those that more
    /// than two faces have.
    pub(super) fn edges(self, count: usize) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
        let mut edges = Vec::new();
        for face in self.below(count) {
            for (one, other) in face
                .iter()
                .zip(face.iter().cycle().skip(1))
                .filter(|(one, other)| one != other)
            {
                edges.push([*one.min(other), *one.max(other)]);
            }
        }
        edges.sort_unstable();
        let crowded = edges
            .chunk_by(|one, other| one == other)
            .filter(|run| run.len() > 2);
        let crowded = crowded.filter_map(|run| run.first().copied()).collect();
        edges.dedup();
        (edges, crowded)
    }
}

/// The triangles of a face, a fan around its first corner.
pub(super) fn fan(face: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    let first = face.first().copied().unwrap_or_default();
    face.windows(2)
        .skip(1)
        .map(move |pair| [first, pair[0], pair[1]])
}

/// Twice the area of a face, in the direction that it looks in.
pub(super) fn vector_of(face: &[u32], positions: &[Point]) -> Vec3 {
    let part = |triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| place(positions, vertex));
        cross(sub(b, a), sub(c, a))
    };
    fan(face).map(part).fold([0.0; 3], add)
}

/// The mean of the vertices of a face.
pub(super) fn middle_of(face: &[u32], positions: &[Point]) -> Vec3 {
    mean(face.iter().map(|vertex| place(positions, *vertex)))
}

/// The mean of points; NaN without any.
pub(super) fn mean(points: impl Iterator<Item = Vec3>) -> Vec3 {
    let (sum, count) = points.fold(([0.0; 3], 0.0), |(sum, count), point| {
        (add(sum, point), count + 1.0)
    });
    scale(sum, 1.0 / count)
}

/// Where a vertex is; the origin for one that does not exist, of which there is none in
/// [`Faces::below`].
pub(super) fn place(positions: &[Point], vertex: u32) -> Vec3 {
    positions
        .get(vertex as usize)
        .map_or([0.0; 3], |point| widen(*point))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_told_once_and_foreign_faces_left_out() {
        let faces = Faces {
            corners: &[0, 1, 2, 3, 2, 1, 4, 0, 1, 9],
            starts: &[0, 4, 7, 10],
        };
        let all = vec![[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]];
        assert_eq!(faces.edges(5), (all, Vec::new()));
        let fins = Faces {
            corners: &[0, 1, 2, 1, 0, 3, 0, 1, 4],
            starts: &[0, 3, 6, 9],
        };
        assert_eq!(fins.edges(5).1, [[0, 1]]);
        assert_eq!(faces.below(5).count(), 2);
        assert_eq!(
            fan(&[5, 6, 7, 8]).collect::<Vec<_>>(),
            [[5, 6, 7], [5, 7, 8]]
        );
    }
}
