//! What MakeHuman 2 adds to fitting: scales, weights taken from the body.
//!
//! Source: `docs/loaders/makehuman2/clothes.md#fitting`.

use super::super::error::EvalError;
use super::super::fit::{Reference, ScaleLine};
use super::super::influences::Influences;
use super::super::load::{WEIGHT_LIMIT, load};
use super::super::mesh::point;
use super::super::vector::{Point, Vec3};
use super::super::weights::{Entry, LoadedWeights, merge_duplicates};

/// Distances below this give no scale, and then the asset is not scaled at all. In mesh units.
pub const SMALLEST_DISTANCE: f32 = 0.01;

/// Scales of the x, y and z axis on a mesh; `None` (no scaling) unless all three lines are there
/// with distances of at least `SMALLEST_DISTANCE`. Assets of type proxy are never scaled: pass
/// `None` to `fit` for them.
///
/// # Errors
/// A vertex outside the mesh.
pub fn axis_scales(
    positions: &[Point],
    lines: [Option<ScaleLine>; 3],
) -> Result<Option<Vec3>, EvalError> {
    let [Some(x), Some(y), Some(z)] = lines else {
        return Ok(None);
    };
    let mut scales = [1.0; 3];
    for (axis, line) in [x, y, z].into_iter().enumerate() {
        // False for NaN.
        let long_enough = line.distance >= SMALLEST_DISTANCE;
        if !long_enough {
            return Ok(None);
        }
        let at = |i: usize| point(positions, line.vertices[i]).map(|p| f64::from(p[axis]));
        scales[axis] = (at(0)? - at(1)?).abs() / f64::from(line.distance);
    }
    Ok(Some(scales))
}

/// Weights of an asset without own weights: body weights times reference weights, products not
/// above `WEIGHT_LIMIT` dropped, then as `load::load`, then entries of one vertex added up.
/// Vertices left without weight go to `root`.
///
/// # Errors
/// None that data can cause: references outside `body` have no weights.
pub fn derived_weights(
    references: &[Reference],
    body: &Influences,
    root: usize,
) -> Result<LoadedWeights, EvalError> {
    let mut lists: Vec<Vec<Entry>> = Vec::new();
    for (vertex, reference) in (0..).zip(references) {
        for (base, share) in reference.vertices.iter().zip(reference.weights) {
            for (bone, weight) in body.of(*base) {
                let product = share * weight;
                if product > WEIGHT_LIMIT {
                    lists.resize_with(lists.len().max(bone + 1), Vec::new);
                    lists[*bone].push((vertex, product));
                }
            }
        }
    }
    let slices: Vec<(usize, &[Entry])> = lists.iter().map(Vec::as_slice).enumerate().collect();
    let mut loaded = load(&slices, root, references.len())?;
    for list in &mut loaded.bones {
        // The root's additions are unsorted, but no vertex among them occurs before.
        merge_duplicates(&mut list.entries);
    }
    Ok(loaded)
}

#[cfg(test)]
mod tests {
    use super::super::super::weights::BoneWeights;
    use super::*;

    const MESH: [Point; 4] = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 8.0]];

    fn line(a: u32, b: u32, distance: f32) -> ScaleLine {
        ScaleLine {
            vertices: [a, b],
            distance,
        }
    }

    #[test]
    fn scales_need_all_three_lines() {
        let (x, y, z) = (line(0, 1, 1.0), line(2, 0, 8.0), line(0, 3, 8.0));
        let scales = |y: ScaleLine, z: ScaleLine| axis_scales(&MESH, [Some(x), Some(y), Some(z)]);
        assert_eq!(scales(y, z), Ok(Some([2.0, 0.5, 1.0])));
        assert_eq!(axis_scales(&MESH, [Some(x), Some(y), None]), Ok(None));
        assert_eq!(scales(line(2, 0, 0.009), z), Ok(None));
        assert_eq!(scales(line(2, 0, f32::NAN), z), Ok(None));
        assert!(scales(line(2, 0, SMALLEST_DISTANCE), z).unwrap().is_some());
        assert_eq!(scales(y, line(0, 9, 1.0)), Err(EvalError::vertex(9, 4)));
    }

    fn body(lists: &[&[(u32, f32)]]) -> Influences {
        let bones: Vec<_> = (0..)
            .zip(lists)
            .map(|(bone, l)| BoneWeights {
                bone,
                entries: l.to_vec(),
            })
            .collect();
        Influences::new(&bones, 4).unwrap()
    }

    #[test]
    fn exact_reference_takes_the_weights_of_its_vertex() {
        let body = body(&[&[(0, 0.25), (1, 1.0)], &[(0, 0.75)]]);
        let found = derived_weights(&[Reference::exact(0)], &body, 9).unwrap();
        assert_eq!(
            found.bones[0],
            BoneWeights {
                bone: 0,
                entries: vec![(0, 0.25)]
            }
        );
        assert_eq!(
            found.bones[1],
            BoneWeights {
                bone: 1,
                entries: vec![(0, 0.75)]
            }
        );
    }

    #[test]
    fn equal_bones_of_the_references_are_added() {
        let body = body(&[&[(0, 1.0), (1, 1.0), (2, 0.5)], &[(2, 0.5)]]);
        let reference = Reference {
            vertices: [0, 1, 2],
            weights: [0.25, 0.25, 0.5],
            offset: [0.0; 3],
        };
        let found = derived_weights(&[reference], &body, 9).unwrap();
        assert_eq!(found.bones[0].entries, [(0, 0.75)]);
        assert_eq!(found.bones[1].entries, [(0, 0.25)]);
    }

    #[test]
    fn negative_and_small_products_are_dropped_before_normalising() {
        let body = body(&[&[(0, 1.0)], &[(1, 1.0)], &[(2, 1.0)]]);
        let reference = Reference {
            vertices: [0, 1, 2],
            weights: [0.5, -0.5, 1e-4],
            offset: [0.0; 3],
        };
        let found = derived_weights(&[reference], &body, 9).unwrap();
        assert_eq!(
            found.bones,
            [BoneWeights {
                bone: 0,
                entries: vec![(0, 1.0)]
            }]
        );
    }

    #[test]
    fn asset_vertex_without_weights_goes_to_the_root() {
        let found = derived_weights(
            &[Reference::exact(3), Reference::exact(77)],
            &body(&[&[(0, 1.0)]]),
            9,
        )
        .unwrap();
        assert_eq!(
            found.bones,
            [BoneWeights {
                bone: 9,
                entries: vec![(0, 1.0), (1, 1.0)]
            }]
        );
    }
}
