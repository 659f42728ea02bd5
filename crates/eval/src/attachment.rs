//! Vertices of what is worn, and the skin that they lie on: over the slider space they stay
//! together.

use super::fit::{Reference, fit};
use super::scene::WornAsset;
use super::surveyor::Anchor;
use super::vector::{Point, Vec3, distance, dot, narrow, sub};

/// Vertices of an asset that are looked at: half of them evenly spread, half of them those tied to
/// vertices that lie farthest apart, in proportion to their weights.
const PROBES: usize = 64;

/// A vertex of an asset with the skin around it.
#[derive(Debug, Clone)]
pub(super) struct Probe {
    /// Number of the asset.
    pub(super) asset: u32,
    /// The vertex.
    pub(super) vertex: u32,
    reference: Reference,
    /// Its offset, scaled as it was when the asset was put on.
    shift: Point,
    /// How far it is from the nearest of its skin on the default character.
    near: f64,
    pub(super) anchor: Anchor,
}

impl Probe {
    /// By how many times its stand the vertex has moved away from the nearest of its skin.
    pub(super) fn drift(&self, positions: &[Point]) -> f64 {
        (from_nearest(self.place(positions), &self.anchor.skin, positions) - self.near)
            / self.anchor.stand
    }

    /// In float32: this is looked at in every setting.
    fn place(&self, positions: &[Point]) -> Point {
        let mut place = self.shift;
        for (vertex, weight) in self.reference.vertices.iter().zip(self.reference.weights) {
            let point = positions.get(*vertex as usize).copied().unwrap_or_default();
            for axis in 0..3 {
                place[axis] += weight * point[axis];
            }
        }
        place
    }

    /// The vertices of the base mesh that it depends on.
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> {
        self.reference
            .vertices
            .iter()
            .chain(&self.anchor.skin)
            .copied()
    }

    /// Those that its row names.
    pub(super) fn named(&self) -> [u32; 3] {
        self.reference.vertices
    }
}

/// The probes of all assets on the default character. `anchor` finds the skin around a place.
pub(super) fn probes(
    worn: &[WornAsset],
    rest: &[Point],
    mut anchor: impl FnMut(usize, Point) -> Option<Anchor>,
) -> Vec<Probe> {
    let mut probes = Vec::new();
    for (asset, worn) in (0..).zip(worn) {
        // An asset whose rows leave the mesh has findings of its own.
        let Ok(fitted) = fit(rest, &worn.references, worn.scales) else {
            continue;
        };
        for vertex in chosen(&worn.references, rest) {
            let Some((place, reference)) = fitted
                .get(vertex)
                .copied()
                .zip(worn.references.get(vertex).copied())
            else {
                continue;
            };
            if place.iter().any(|part| !part.is_finite()) {
                continue;
            }
            let Some(anchor) = anchor(vertex, place) else {
                return probes;
            };
            let (shift, near) = (
                shift(&reference, worn.scales),
                from_nearest(place, &anchor.skin, rest),
            );
            let vertex = u32::try_from(vertex).unwrap_or(u32::MAX);
            probes.push(Probe {
                asset,
                vertex,
                reference,
                shift,
                near,
                anchor,
            });
        }
    }
    probes
}

/// In float32, as it is asked for in every setting.
fn from_nearest(place: Point, skin: &[u32], positions: &[Point]) -> f64 {
    let points = skin
        .iter()
        .filter_map(|vertex| positions.get(*vertex as usize));
    let squares = points
        .map(|point| sub(*point, place))
        .map(|way| dot(way, way));
    f64::from(squares.fold(f32::MAX, f32::min).sqrt())
}

fn shift(reference: &Reference, scales: Option<Vec3>) -> Point {
    let scales = scales.unwrap_or([1.0; 3]);
    narrow([0, 1, 2].map(|axis| f64::from(reference.offset[axis]) * scales[axis]))
}

/// The vertices of an asset to look at, in order.
fn chosen(references: &[Reference], rest: &[Point]) -> Vec<usize> {
    let half = PROBES / 2;
    let mut chosen: Vec<usize> = (0..references.len())
        .step_by(references.len().div_ceil(half).max(1))
        .collect();
    let mut spans: Vec<(f64, usize)> = references
        .iter()
        .enumerate()
        .map(|(vertex, reference)| (span(reference, rest), vertex))
        .collect();
    if spans.len() > half {
        spans.select_nth_unstable_by(half, |one, other| {
            other.0.total_cmp(&one.0).then(one.1.cmp(&other.1))
        });
        spans.truncate(half);
    }
    chosen.extend(spans.into_iter().map(|(_, vertex)| vertex));
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

/// How far apart the vertices of a row are, times what they weigh.
fn span(reference: &Reference, rest: &[Point]) -> f64 {
    let at = |vertex: u32| rest.get(vertex as usize).copied().unwrap_or_default();
    let [a, b, c] = reference.vertices.map(at);
    let weight: f32 = reference.weights.iter().map(|weight| weight.abs()).sum();
    let span = (distance(a, b) + distance(b, c) + distance(c, a)) * f64::from(weight);
    if span.is_nan() { 0.0 } else { span }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_and_far_tied_vertices_are_looked_at() {
        let rest: Vec<Point> = (0..10_u8).map(|at| [f32::from(at), 0.0, 0.0]).collect();
        let mut references = vec![Reference::exact(3); 1000];
        references[777] = Reference {
            vertices: [0, 5, 9],
            weights: [0.4, 0.3, 0.3],
            offset: [0.0; 3],
        };
        let chosen = chosen(&references, &rest);
        assert!(chosen.len() <= PROBES && chosen.contains(&777) && chosen.contains(&0));
        assert_eq!(super::chosen(&[], &rest), [0; 0]);
    }

    #[test]
    fn a_vertex_that_follows_its_skin_does_not_drift() {
        let rest = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        let reference = Reference {
            vertices: [0, 1, 2],
            weights: [0.0, 0.5, 0.5],
            offset: [0.0, 0.0, 0.1],
        };
        let worn = [WornAsset {
            path: String::new(),
            references: vec![reference],
            scales: Some([1.0, 1.0, 2.0]),
            weights: None,
        }];
        let anchor = |joint, place| {
            let skin = vec![0, 1, 2, 3];
            Some(Anchor {
                joint,
                distance: from_nearest(place, &skin, &rest),
                stand: 0.5,
                skin,
            })
        };
        let probes = probes(&worn, &rest, anchor);
        let [probe] = probes.as_slice() else {
            panic!("{probes:?}")
        };
        assert!((probe.near - 0.54f64.sqrt()).abs() < 1e-6, "{}", probe.near);
        let moved = rest.map(|p| [p[0] + 3.0, p[1], p[2] - 1.0]);
        assert!(probe.drift(&moved).abs() < 1e-6);
        let torn = [rest[0], rest[1], [0.0, 9.0, 0.0], rest[3]];
        assert!(probe.drift(&torn) > 1.0, "{}", probe.drift(&torn));
        assert_eq!(probe.vertices().count(), 7);
    }
}
