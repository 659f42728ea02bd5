//! What MakeHuman 1 adds to fitting: scales with the sign of their divisor, and shears.
//!
//! Source: `docs/loaders/makehuman1/clothes.md#fitting`.

use super::super::error::EvalError;
use super::super::fit::ScaleLine;
use super::super::mesh::point;
use super::super::vector::{Point, Vec3};

/// A line of shear: two base vertices and the coordinates that they had on that axis when the asset
/// was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearLine {
    /// The two vertices.
    pub vertices: [u32; 2],
    /// Their coordinates, mesh units.
    pub places: [f32; 2],
}

/// What offsets are multiplied by: the lines of scale, or else the first whole set of shear lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stretch {
    /// `x_scale`, `y_scale`, `z_scale`.
    pub scales: [Option<ScaleLine>; 3],
    /// `shear_x` and so on; those of the left half, of the right half.
    pub shears: [[Option<ShearLine>; 3]; 3],
}

impl Stretch {
    /// The factors on a mesh. `None` for 1: nothing is said. A divisor of 0 gives infinite factors
    /// or NaN, as it does to the application.
    ///
    /// # Errors
    /// A vertex outside the mesh; a scale with one or two axes alone, at which the application
    /// stops.
    pub fn factors(&self, positions: &[Point]) -> Result<Option<Vec3>, EvalError> {
        if self.scales.iter().any(Option::is_some) {
            let mut factors = [1.0; 3];
            for (axis, line) in self.scales.iter().enumerate() {
                let Some(line) = line else {
                    return Err(EvalError::IncompleteScale { axis });
                };
                let along =
                    |i: usize| point(positions, line.vertices[i]).map(|p| f64::from(p[axis]));
                factors[axis] = (along(0)? - along(1)?).abs() / f64::from(line.distance);
            }
            return Ok(Some(factors));
        }
        let Some([Some(x), Some(y), Some(z)]) = self
            .shears
            .iter()
            .find(|set| set.iter().all(Option::is_some))
        else {
            return Ok(None);
        };
        let mut factors = [1.0; 3];
        for (axis, line) in [x, y, z].into_iter().enumerate() {
            let along = |i: usize| point(positions, line.vertices[i]).map(|p| f64::from(p[axis]));
            factors[axis] =
                (along(0)? - along(1)?) / (f64::from(line.places[0]) - f64::from(line.places[1]));
        }
        Ok(Some(factors))
    }
}

/// What the marks of assets above hide of an asset: a vertex with one base vertex where that is
/// hidden, one with three where two of them are. `hidden` are the base vertices.
pub fn hidden_vertices(references: &[super::super::fit::Reference], hidden: &[bool]) -> Vec<bool> {
    let is_hidden = |vertex: u32| hidden.get(vertex as usize) == Some(&true);
    let of = |reference: &super::super::fit::Reference| {
        let [first, ..] = reference.vertices;
        let is_exact = reference.vertices.iter().all(|vertex| *vertex == first);
        let count = reference
            .vertices
            .iter()
            .filter(|vertex| is_hidden(**vertex))
            .count();
        if is_exact {
            is_hidden(first)
        } else {
            count >= 2
        }
    };
    references.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::fit::{Reference, fit};
    use super::*;

    const MESH: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 8.0]];

    fn scale(a: u32, b: u32, distance: f32) -> ScaleLine {
        ScaleLine {
            vertices: [a, b],
            distance,
        }
    }

    fn shear(a: u32, b: u32, places: [f32; 2]) -> ShearLine {
        ShearLine {
            vertices: [a, b],
            places,
        }
    }

    #[test]
    fn scales_keep_the_sign_of_their_divisor() {
        let stretch = Stretch {
            scales: [scale(0, 1, -1.0), scale(2, 0, 8.0), scale(0, 3, 8.0)].map(Some),
            ..Stretch::default()
        };
        assert_eq!(stretch.factors(&MESH), Ok(Some([-2.0, 0.5, 1.0])));
        let small = Stretch {
            scales: [scale(0, 1, 0.001), scale(2, 0, 8.0), scale(0, 3, 8.0)].map(Some),
            ..Stretch::default()
        };
        assert!((small.factors(&MESH).unwrap().unwrap()[0] - 2000.0).abs() < 0.01);
        let none = Stretch {
            scales: [scale(0, 1, 0.0), scale(2, 0, 8.0), scale(0, 3, 8.0)].map(Some),
            ..Stretch::default()
        };
        assert_eq!(none.factors(&MESH).unwrap().unwrap()[0], f64::INFINITY);
    }

    #[test]
    fn a_scale_needs_all_axes_and_stands_before_shears() {
        let whole = [
            shear(1, 0, [1.0, 0.0]),
            shear(2, 0, [0.0, 2.0]),
            shear(3, 0, [4.0, 0.0]),
        ]
        .map(Some);
        let mut stretch = Stretch {
            shears: [[None; 3], whole, [None; 3]],
            ..Stretch::default()
        };
        assert_eq!(stretch.factors(&MESH), Ok(Some([2.0, -2.0, 2.0])));
        stretch.scales[1] = Some(scale(2, 0, 8.0));
        assert_eq!(
            stretch.factors(&MESH),
            Err(EvalError::IncompleteScale { axis: 0 })
        );
        assert_eq!(Stretch::default().factors(&MESH), Ok(None));
        stretch.scales[1] = None;
        stretch.shears[1][2] = None;
        assert_eq!(stretch.factors(&MESH), Ok(None));
    }

    #[test]
    fn the_first_whole_set_of_shears_counts() {
        let set = |x: f32| {
            [
                shear(1, 0, [x, 0.0]),
                shear(2, 0, [4.0, 0.0]),
                shear(3, 0, [8.0, 0.0]),
            ]
            .map(Some)
        };
        let stretch = Stretch {
            shears: [set(1.0), set(4.0), set(8.0)],
            ..Stretch::default()
        };
        assert_eq!(stretch.factors(&MESH), Ok(Some([2.0, 1.0, 1.0])));
    }

    /// `p = w0·H[v0] + w1·H[v1] + w2·H[v2] + M·d`, by hand.
    #[test]
    fn a_row_goes_where_the_formula_says() {
        let stretch = Stretch {
            scales: [scale(0, 1, 1.0), scale(0, 2, 8.0), scale(0, 3, 4.0)].map(Some),
            ..Stretch::default()
        };
        let rows = [Reference {
            vertices: [1, 2, 3],
            weights: [0.5, 0.25, 0.25],
            offset: [0.1, 0.2, 0.3],
        }];
        let found = fit(&MESH, &rows, stretch.factors(&MESH).unwrap()).unwrap();
        for (part, expected) in found[0].iter().zip([1.2, 1.1, 2.6]) {
            assert!((part - expected).abs() < 1e-6, "{found:?}");
        }
    }

    #[test]
    fn what_is_above_hides_by_two_of_three() {
        let row = |vertices| Reference {
            vertices,
            weights: [0.4, 0.3, 0.3],
            offset: [0.0; 3],
        };
        let rows = [row([0, 1, 2]), row([1, 2, 3]), row([3; 3]), row([0; 3])];
        assert_eq!(
            hidden_vertices(&rows, &[true, true, false, false]),
            [true, false, false, true]
        );
    }
}
