//! Assets on a mesh of MPFB, the vertices that they hide, and the weights that they take from it.
//!
//! Source: MPFB (`docs/loaders/mpfb/clothes.md#fitting`,
//! `docs/loaders/mpfb/clothes.md#delete-group`,
//! `docs/loaders/mpfb/clothes.md#interpolated-weights`; `reference/README.md`, `mpfb_fit`).

use std::collections::BTreeMap;

use super::groups::VertexGroup;
use crate::vector::{Point, Vec3, add, narrow, scale, widen};

/// A vertex of an asset, as its file has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Vertices of the base mesh.
    pub vertices: [i64; 3],
    /// Their weights, used as they are.
    pub weights: [f64; 3],
    /// Displacement in the axes of the file.
    pub offset: Vec3,
}

/// Two vertices of the base mesh and the distance that they had.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaleLine {
    /// The vertices.
    pub vertices: [i64; 2],
    /// The distance in units of the file.
    pub distance: f64,
}

/// What stops MPFB when it fits an asset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// `x_scale` without one of the others.
    ScaleMissing,
    /// A distance of 0.
    NoDistance,
    /// A vertex of a scale that does not exist.
    ScaleVertex,
    /// A second vertex of a row that does not exist.
    RowVertex,
}

/// What offsets are multiplied by along x, y and z of Blender. Lines are those of x, y and z of the
/// file.
///
/// # Errors
/// What stops MPFB.
pub fn scales(
    mesh: &[Point],
    lines: [Option<ScaleLine>; 3],
    scale_factor: f64,
) -> Result<Vec3, Stop> {
    let [Some(x), y, z] = lines else {
        return Ok([scale_factor; 3]);
    };
    let (y, z) = (y.ok_or(Stop::ScaleMissing)?, z.ok_or(Stop::ScaleMissing)?);
    let measured = |line: ScaleLine, axis: usize| {
        let at = |vertex: i64| {
            vertex_of(mesh, vertex)
                .map(|point| point[axis])
                .ok_or(Stop::ScaleVertex)
        };
        let [from, to] = line.vertices;
        let (from, to) = (at(from)?, at(to)?);
        if line.distance == 0.0 {
            Err(Stop::NoDistance)
        } else {
            Ok((from - to).abs() / line.distance)
        }
    };
    // Up in the file is z of Blender, its depth y.
    Ok([measured(x, 0)?, measured(z, 1)?, measured(y, 2)?])
}

/// An asset on a mesh. A vertex whose first or third vertex does not exist stays where its OBJ has
/// it.
///
/// # Errors
/// What stops MPFB.
pub fn fitted(
    mesh: &[Point],
    rows: &[Row],
    scales: Vec3,
    drawn: &[Point],
) -> Result<Vec<Point>, Stop> {
    let [across, deep, up] = scales;
    let place = |(row, drawn): (&Row, &Point)| {
        let [a, b, c] = row.vertices.map(|vertex| vertex_of(mesh, vertex));
        let second = b.or_else(|| {
            if a.is_none() || c.is_none() {
                Some([0.0; 3])
            } else {
                None
            }
        });
        let (Some(b), Some(a), Some(c)) = (second, a, c) else {
            return if second.is_none() {
                Err(Stop::RowVertex)
            } else {
                Ok(*drawn)
            };
        };
        let [dx, dy, dz] = row.offset;
        let mut sum = [across * dx, -deep * dz, up * dy];
        for (vertex, weight) in [a, b, c].into_iter().zip(row.weights) {
            sum = add(sum, scale(vertex, weight));
        }
        Ok(narrow(sum))
    };
    rows.iter().zip(drawn).map(place).collect()
}

/// A vertex of the mesh; negative ones count from the end.
fn vertex_of(mesh: &[Point], vertex: i64) -> Option<Vec3> {
    let count = i64::try_from(mesh.len()).ok()?;
    let at = if vertex < 0 {
        vertex.checked_add(count)?
    } else {
        vertex
    };
    mesh.get(usize::try_from(at).ok()?).copied().map(widen)
}

/// Vertices that an asset hides. Each face of which only some are listed takes one listing of each
/// of these away; what is left is hidden.
pub fn hidden<'f>(
    listed: &[i64],
    vertices: usize,
    faces: impl Iterator<Item = &'f [u32]>,
) -> Vec<usize> {
    let mut listings = vec![0_usize; vertices];
    for vertex in listed
        .iter()
        .filter_map(|vertex| usize::try_from(*vertex).ok())
    {
        if let Some(count) = listings.get_mut(vertex) {
            *count += 1;
        }
    }
    let is_listed: Vec<bool> = listings.iter().map(|count| *count > 0).collect();
    let is = |vertex: &u32| is_listed.get(*vertex as usize) == Some(&true);
    for face in faces {
        let own = face.iter().filter(|vertex| is(vertex)).count();
        if own == 0 || own == face.len() {
            continue;
        }
        for vertex in face.iter().filter(|vertex| is(vertex)) {
            if let Some(count) = listings.get_mut(*vertex as usize) {
                *count = count.saturating_sub(1);
            }
        }
    }
    listings
        .iter()
        .enumerate()
        .filter(|(_, count)| **count > 0)
        .map(|(vertex, _)| vertex)
        .collect()
}

/// Smaller weights are left out.
const LEAST: f64 = 0.001;

/// Weights of an asset, taken from the vertices of the body that its rows name. Groups without any
/// are left out.
pub fn interpolated(rows: &[Row], body: &[VertexGroup]) -> Vec<VertexGroup> {
    let of_group = |(name, own): &VertexGroup| {
        let weight = |row: &Row| {
            let of = |vertex: i64| {
                usize::try_from(vertex)
                    .ok()
                    .and_then(|vertex| own.get(&vertex))
                    .copied()
            };
            let shares = row.vertices.into_iter().zip(row.weights);
            let sum: f64 = shares
                .map(|(vertex, share)| share * of(vertex).unwrap_or(0.0))
                .sum();
            sum / row.weights.iter().sum::<f64>()
        };
        let weights = rows
            .iter()
            .enumerate()
            .map(|(at, row)| (at, weight(row)))
            .filter(|(_, weight)| *weight > LEAST);
        // Blender keeps no weight above 1, as negative shares make it.
        let weights: BTreeMap<usize, f64> =
            weights.map(|(at, weight)| (at, weight.min(1.0))).collect();
        (name.clone(), weights)
    };
    body.iter()
        .map(of_group)
        .filter(|(_, weights)| !weights.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESH: [Point; 3] = [[0.0, 0.0, 0.0], [2.0, 4.0, 8.0], [1.0, 0.0, 0.0]];

    const fn line(distance: f64) -> ScaleLine {
        ScaleLine {
            vertices: [0, 1],
            distance,
        }
    }

    #[test]
    fn scales_are_those_of_blender_s_axes() {
        assert_eq!(
            scales(
                &MESH,
                [Some(line(1.0)), Some(line(2.0)), Some(line(4.0))],
                0.1
            ),
            Ok([2.0, 1.0, 4.0])
        );
        assert_eq!(
            scales(&MESH, [None, Some(line(2.0)), Some(line(4.0))], 0.1),
            Ok([0.1; 3])
        );
        assert_eq!(
            scales(&MESH, [Some(line(1.0)), Some(line(2.0)), None], 0.1),
            Err(Stop::ScaleMissing)
        );
        assert_eq!(
            scales(
                &MESH,
                [Some(line(0.0)), Some(line(2.0)), Some(line(1.0))],
                0.1
            ),
            Err(Stop::NoDistance)
        );
        let beyond = Some(ScaleLine {
            vertices: [0, 3],
            distance: 1.0,
        });
        assert_eq!(
            scales(&MESH, [beyond, Some(line(2.0)), Some(line(1.0))], 0.1),
            Err(Stop::ScaleVertex)
        );
    }

    #[test]
    fn a_lost_vertex_stays_where_it_was_drawn() {
        let row = |vertices| Row {
            vertices,
            weights: [1.0, 0.0, 0.0],
            offset: [1.0, 2.0, 3.0],
        };
        let rows = [row([2, 0, 0]), row([-1, 0, 0]), row([9, 0, 0])];
        let fit = fitted(&MESH, &rows, [1.0; 3], &[[7.0; 3]; 3]).unwrap();
        assert_eq!(fit, [[2.0, -3.0, 2.0], [2.0, -3.0, 2.0], [7.0; 3]]);
        assert_eq!(
            fitted(&MESH, &[row([0, 3, 0])], [1.0; 3], &[[7.0; 3]]),
            Err(Stop::RowVertex)
        );
    }

    #[test]
    fn partly_listed_faces_take_a_listing_away() {
        let faces: [&[u32]; 2] = [&[0, 1, 2], &[2, 3, 4]];
        let of = |listed: &[i64]| hidden(listed, 5, faces.into_iter());
        assert_eq!(of(&[0, 1, 2]), [0, 1]);
        assert_eq!(of(&[0, 1, 2, 2]), [0, 1, 2]);
        assert_eq!(of(&[0, 1, 2, 3, 4, 9, -1]), [0, 1, 2, 3, 4]);
        assert!(of(&[3]).is_empty());
    }

    #[test]
    fn weights_are_shared_out_by_the_rows() {
        let body = vec![
            ("a".to_owned(), BTreeMap::from([(0, 1.0)])),
            ("b".to_owned(), BTreeMap::from([(2, 0.001)])),
        ];
        let row = Row {
            vertices: [0, 1, 2],
            weights: [1.0, 0.5, 0.5],
            offset: [0.0; 3],
        };
        assert_eq!(
            interpolated(&[row], &body),
            [("a".to_owned(), BTreeMap::from([(0, 0.5)]))]
        );
        let beyond = Row {
            weights: [1.5, -0.5, 0.0],
            ..row
        };
        assert_eq!(
            interpolated(&[beyond], &body),
            [("a".to_owned(), BTreeMap::from([(0, 1.0)]))]
        );
    }
}
