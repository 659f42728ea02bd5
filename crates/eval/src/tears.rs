//! Whether displacements tear a mesh: how far a vertex moves compared with those next to it.
//!
//! The median of a target says nothing of a limb that is far away from all else, such as a tail
//! that grows: there each vertex moves nearly as far as the next one, and nothing tears.

use std::collections::BTreeSet;

use super::lists::Lists;
use super::vector::{Point, dot, sub};

/// Neighbours tear apart that move differently by more than this part of the longest displacement
/// around.
const TEAR: f32 = 0.5;

/// Which vertices are next to one another: the ends of the edges of faces.
#[derive(Debug)]
pub struct Neighbours(Lists<u32>);

impl Neighbours {
    /// Those of a mesh with so many vertices.
    pub fn new<'f>(vertices: usize, faces: impl Iterator<Item = &'f [u32]> + Clone) -> Self {
        let edges = faces.flat_map(|face| {
            let next = face.iter().cycle().skip(1);
            face.iter()
                .zip(next)
                .flat_map(|(one, other)| [(*one as usize, *other), (*other as usize, *one)])
        });
        Self(Lists::new(vertices, edges))
    }

    /// Those of the vertices that hang together with a tear, or with nothing. `moved` says how a
    /// vertex moves; one of which that is not known moves by `least` at most.
    pub fn torn(
        &self,
        vertices: &BTreeSet<u32>,
        least: f32,
        moved: impl Fn(u32) -> Option<Point>,
    ) -> BTreeSet<u32> {
        let mut torn = BTreeSet::new();
        let mut left = vertices.clone();
        while let Some(first) = left.pop_first() {
            let part = self.part(first, &mut left);
            let longest = part
                .iter()
                .filter_map(|vertex| moved(*vertex))
                .map(length)
                .fold(0.0, f32::max);
            let apart = |one: u32, other: u32| match (moved(one), moved(other)) {
                (Some(one), Some(other)) => length(sub(one, other)),
                (Some(known), None) | (None, Some(known)) => length(known) - least,
                (None, None) => 0.0,
            };
            let is_torn = |vertex: &u32| {
                let around = self.0.of(*vertex as usize);
                // What is not finite is apart from everything.
                around.is_empty()
                    || around
                        .iter()
                        .any(|other| !(apart(*vertex, *other) <= longest * TEAR))
            };
            if part.iter().any(is_torn) {
                torn.extend(part);
            }
        }
        torn
    }

    /// What hangs together with a vertex, taken out of what is left.
    fn part(&self, first: u32, left: &mut BTreeSet<u32>) -> Vec<u32> {
        let mut part = vec![first];
        let mut next = 0;
        while let Some(vertex) = part.get(next).copied() {
            next += 1;
            part.extend(
                self.0
                    .of(vertex as usize)
                    .iter()
                    .filter(|other| left.remove(other)),
            );
        }
        part
    }
}

pub(super) fn length(way: Point) -> f32 {
    dot(way, way).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of quads: vertices 0, 1 to 2n, 2n + 1.
    fn strip(quads: u32) -> (Neighbours, usize) {
        let faces: Vec<[u32; 4]> = (0..quads)
            .map(|at| [2 * at, 2 * at + 1, 2 * at + 3, 2 * at + 2])
            .collect();
        let count = 2 * quads as usize + 2;
        (
            Neighbours::new(count, faces.iter().map(<[u32; 4]>::as_slice)),
            count,
        )
    }

    fn torn(of: &dyn Fn(u32) -> Option<f32>) -> Vec<u32> {
        let (neighbours, count) = strip(20);
        let vertices: BTreeSet<u32> = (0..u32::try_from(count).unwrap())
            .filter(|vertex| of(*vertex).is_some_and(|way| way > 2.0))
            .collect();
        let moved = |vertex: u32| of(vertex).map(|way| [0.0, way, 0.0]);
        neighbours.torn(&vertices, 2.0, moved).into_iter().collect()
    }

    #[test]
    fn what_grows_from_vertex_to_vertex_is_not_torn() {
        assert_eq!(torn(&|vertex| Some((vertex / 2) as f32 * 0.5)), [0_u32; 0]);
        assert_eq!(
            torn(&|vertex| Some((vertex / 2) as f32 * 0.5).filter(|way| *way > 2.0)),
            [0_u32; 0]
        );
    }

    #[test]
    fn one_that_leaves_the_others_is() {
        assert_eq!(
            torn(&|vertex| Some(if vertex == 7 { 10.0 } else { 0.1 })),
            [7]
        );
        assert_eq!(torn(&|vertex| (vertex == 7).then_some(10.0)), [7]);
        assert_eq!(
            torn(&|vertex| (vertex == 7).then_some(f32::NAN)),
            [0_u32; 0]
        );
    }

    #[test]
    fn a_whole_part_that_leaves_the_others_is_torn_off() {
        let all: Vec<u32> = (20..42).collect();
        assert_eq!(
            torn(&|vertex| Some(if vertex < 20 { 0.1 } else { 10.0 })),
            all
        );
        // One that tears does not make a tail torn that grows somewhere else.
        let both = |vertex: u32| match vertex {
            3 => 10.0,
            0..=9 => 0.0,
            _ => (vertex / 2) as f32 * 0.25,
        };
        assert_eq!(torn(&|vertex| Some(both(vertex))), [3]);
    }

    #[test]
    fn a_vertex_without_faces_is_next_to_nothing() {
        let neighbours = Neighbours::new(3, std::iter::empty());
        assert_eq!(
            neighbours.torn(&BTreeSet::from([2, 9]), 0.0, |_| Some([1.0; 3])),
            BTreeSet::from([2, 9])
        );
    }
}
