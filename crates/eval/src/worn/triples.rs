//! Rows whose three vertices make no triangle.

use crate::fit::Reference;
use crate::vector::{Point, cross, length, sub, widen};

/// What is wrong with three vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TripleFault {
    /// All three are one.
    One,
    /// Two are one, with a weight each.
    Two,
    /// They lie on a line.
    Line,
}

/// Rows at fault.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Triples {
    /// Their numbers with what is wrong, in order.
    pub faults: Vec<(usize, TripleFault)>,
}

/// The area of a triangle on a line is below this part of the square of its extent.
const LINE: f64 = 1e-6;

pub(super) fn measure(positions: &[Point], references: &[Reference]) -> Triples {
    let faults = references.iter().enumerate();
    let faults = faults
        .filter_map(|(row, reference)| Some((row, fault(positions, reference)?)))
        .collect();
    Triples { faults }
}

fn fault(positions: &[Point], reference: &Reference) -> Option<TripleFault> {
    let (vertices, weights) = (reference.vertices, reference.weights);
    // One that counts alone needs no others.
    let counting = weights.iter().filter(|weight| **weight != 0.0).count();
    if counting < 2 {
        return None;
    }
    let [a, b, c] = vertices;
    if a == b && b == c {
        return Some(TripleFault::One);
    }
    let both_count = |one: usize, other: usize| weights[one] != 0.0 && weights[other] != 0.0;
    let is_one = |one: usize, other: usize| vertices[one] == vertices[other];
    let pairs = [(0, 1), (1, 2), (0, 2)];
    if pairs
        .iter()
        .any(|(one, other)| is_one(*one, *other) && both_count(*one, *other))
    {
        return Some(TripleFault::Two);
    }
    if counting < 3 {
        return None;
    }
    let at = |vertex: u32| positions.get(vertex as usize).map(|point| widen(*point));
    let (a, b, c) = (at(a)?, at(b)?, at(c)?);
    let extent = length(sub(b, a)) + length(sub(c, b)) + length(sub(a, c));
    let area = length(cross(sub(b, a), sub(c, a))) / 2.0;
    (area < LINE * extent * extent).then_some(TripleFault::Line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triples_are_told_by_what_counts() {
        let positions = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let of = |vertices, weights| {
            fault(
                &positions,
                &Reference {
                    vertices,
                    weights,
                    offset: [0.0; 3],
                },
            )
        };
        assert_eq!(of([0, 1, 3], [0.5, 0.25, 0.25]), None);
        assert_eq!(of([1, 1, 1], [0.5, 0.25, 0.25]), Some(TripleFault::One));
        assert_eq!(of([1, 1, 1], [1.0, 0.0, 0.0]), None);
        assert_eq!(of([1, 3, 1], [0.5, 0.25, 0.25]), Some(TripleFault::Two));
        assert_eq!(of([1, 3, 1], [0.5, 0.5, 0.0]), None);
        assert_eq!(of([0, 1, 2], [0.5, 0.25, 0.25]), Some(TripleFault::Line));
        assert_eq!(of([0, 1, 2], [0.5, 0.5, 0.0]), None);
    }
}
