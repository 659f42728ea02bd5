//! Which items (faces) lie around a vertex: so that a setting that moves a few vertices costs a few faces.

/// Items around each vertex.
#[derive(Debug, Clone, Default)]
pub(super) struct Nearby {
    /// Where the items of each vertex begin, and one entry for the end.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Nearby {
    /// Gets the vertices of each item. Vertices beyond `vertex_count` are left out.
    pub(super) fn new<'f>(vertex_count: usize, items: impl Iterator<Item = &'f [u32]> + Clone) -> Self {
        let mut starts = vec![0_u32; vertex_count + 1];
        let corners = || items.clone().flatten().map(|vertex| *vertex as usize).filter(|vertex| *vertex < vertex_count);
        for vertex in corners() {
            starts[vertex + 1] += 1;
        }
        for vertex in 0..vertex_count {
            starts[vertex + 1] += starts[vertex];
        }
        let mut next = starts.clone();
        let mut list = vec![0; starts[vertex_count] as usize];
        for (number, vertices) in (0_u32..).zip(items) {
            for vertex in vertices.iter().map(|vertex| *vertex as usize).filter(|vertex| *vertex < vertex_count) {
                list[next[vertex] as usize] = number;
                next[vertex] += 1;
            }
        }
        Self { starts, items: list }
    }

    /// Numbers of the items around some vertices, each once, in order.
    pub(super) fn around(&self, vertices: &[u32]) -> Vec<u32> {
        let of = |vertex: &u32| {
            let ends = self.starts.get(*vertex as usize).zip(self.starts.get(*vertex as usize + 1));
            ends.and_then(|(start, end)| self.items.get(*start as usize..*end as usize)).unwrap_or_default()
        };
        let mut found: Vec<u32> = vertices.iter().flat_map(of).copied().collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_around_vertices_come_once() {
        let faces: [&[u32]; 3] = [&[0, 1, 2], &[2, 1, 3], &[4, 5, 99]];
        let nearby = Nearby::new(6, faces.iter().copied());
        assert_eq!(nearby.around(&[1, 2]), [0, 1]);
        assert_eq!(nearby.around(&[5]), [2]);
        assert_eq!(nearby.around(&[99]), [0_u32; 0]);
    }
}
