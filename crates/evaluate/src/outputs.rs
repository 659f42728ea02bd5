//! Outcomes as JSON, in the field names of the reference files of the applications.
//!
//! Results are rounded to 7 significant digits (what float32 storage holds) and -0 is written as 0;
//! NaN and infinity become `null`, since JSON has no word for them.

use serde_json::{Map, Value, json};

use super::data::{Fitted, NamedWeights, RestSkeleton};
use super::error::Error;
use super::pose::PosedBase;
use mhlint_eval::influences::{Influences, Reduction};
use mhlint_eval::mesh::{bounding_box, coordinate_sum};
use mhlint_eval::vector::{Mat4, Point, Vec3, widen};

/// A number with 7 significant digits.
pub(super) fn rounded(value: f64) -> Value {
    let short = format!("{value:.6e}").parse::<f64>().unwrap_or(value);
    Value::from(if short == 0.0 { 0.0 } else { short })
}

pub(super) fn vector(v: Vec3) -> Value {
    Value::from(v.map(rounded).to_vec())
}

pub(super) fn point(p: Point) -> Value {
    vector(widen(p))
}

fn matrix(m: &Mat4) -> Value {
    m.iter().flatten().map(|x| rounded(*x)).collect()
}

/// An object of the given members.
pub fn object<const N: usize>(members: [(&str, Value); N]) -> Map<String, Value> {
    members
        .into_iter()
        .map(|(key, value)| (key.to_owned(), value))
        .collect()
}

/// Chosen vertices, bounding box and sums of a mesh.
///
/// # Errors
/// A chosen vertex that the mesh does not have.
pub fn mesh_json(positions: &[Point], vertices: &[i64]) -> Result<Map<String, Value>, Error> {
    let mut chosen = Vec::new();
    for vertex in vertices {
        let found = usize::try_from(*vertex)
            .ok()
            .and_then(|vertex| positions.get(vertex));
        let outside = || {
            Error::Input(format!(
                "vertex {vertex} is outside the mesh of {} vertices",
                positions.len()
            ))
        };
        chosen.push(point(*found.ok_or_else(outside)?));
    }
    let sum = coordinate_sum(positions);
    Ok(object([
        ("vertices", Value::from(chosen)),
        (
            "bbox",
            bounding_box(positions)
                .map_or(Value::Null, |(low, high)| json!([point(low), point(high)])),
        ),
        ("sum_xyz", vector(sum)),
        ("sum", rounded(sum.iter().sum())),
    ]))
}

/// Joints and bones in rest pose.
pub fn skeleton_json(rest: &RestSkeleton) -> Map<String, Value> {
    let joints = rest
        .skeleton
        .joint_names
        .iter()
        .zip(&rest.joints)
        .map(|(name, p)| (name.clone(), point(*p)));
    let bones = rest
        .skeleton
        .names
        .iter()
        .zip(&rest.bones)
        .map(|(name, bone)| {
            let fields = object([
                ("head", point(bone.head)),
                ("tail", point(bone.tail)),
                ("length", rounded(bone.length)),
                ("matRestGlobal", matrix(&bone.global)),
            ]);
            (name.clone(), Value::Object(fields))
        });
    object([
        ("joints", Value::Object(joints.collect())),
        ("bones", Value::Object(bones.collect())),
    ])
}

/// A posed mesh and its posed bones.
///
/// # Errors
/// As [`mesh_json`].
pub fn skin_json(posed: &PosedBase, vertices: &[i64]) -> Result<Map<String, Value>, Error> {
    let bones = posed.bones.iter().map(|(name, head, tail, moved)| {
        let fields = object([
            ("head", vector(*head)),
            ("tail", vector(*tail)),
            ("matPoseVerts", matrix(moved)),
        ]);
        (name.clone(), Value::Object(fields))
    });
    let mut outputs = mesh_json(&posed.positions, vertices)?;
    outputs.insert("bones".to_owned(), Value::Object(bones.collect()));
    Ok(outputs)
}

/// A fitted asset.
///
/// # Errors
/// As [`mesh_json`].
pub fn fit_json(fitted: &Fitted, vertices: &[i64]) -> Result<Map<String, Value>, Error> {
    let mut outputs = mesh_json(&fitted.positions, vertices)?;
    outputs.extend(object([
        ("scale", fitted.scales.map_or(Value::Null, vector)),
        ("vertex_count", Value::from(fitted.positions.len())),
        ("ref_count", Value::from(fitted.references)),
        ("delete_verts", Value::from(fitted.deleted)),
    ]));
    Ok(outputs)
}

/// Entries and sum of every bone, bones of chosen vertices, and the range of the sums of vertices.
pub fn weights_json(
    weights: &NamedWeights,
    influences: &Influences,
    vertices: &[i64],
) -> Map<String, Value> {
    let name = |bone: usize| weights.names.get(bone).cloned().unwrap_or_default();
    let bones = weights.loaded.bones.iter().map(|list| {
        let sum: f64 = list
            .entries
            .iter()
            .map(|(_, weight)| f64::from(*weight))
            .sum();
        (name(list.bone), json!([list.entries.len(), rounded(sum)]))
    });
    let chosen = vertices.iter().map(|vertex| {
        let of = u32::try_from(*vertex)
            .map(|vertex| influences.of(vertex))
            .unwrap_or_default();
        let pairs: Vec<Value> = of
            .iter()
            .map(|(bone, w)| json!([name(*bone), rounded(f64::from(*w))]))
            .collect();
        json!([vertex, pairs])
    });
    let sums = influences
        .iter()
        .map(|of| of.iter().map(|(_, weight)| f64::from(*weight)).sum::<f64>());
    let (low, high) = sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), sum| {
        (low.min(sum), high.max(sum))
    });
    object([
        ("bones", Value::Object(bones.collect())),
        ("vertices", chosen.collect()),
        ("vertex_sum_range", json!([rounded(low), rounded(high)])),
    ])
}

/// The lists themselves.
pub(super) fn weight_lists_json(weights: &NamedWeights) -> Map<String, Value> {
    let lists = weights.loaded.bones.iter().map(|list| {
        let name = weights.names.get(list.bone).cloned().unwrap_or_default();
        let pairs = list
            .entries
            .iter()
            .map(|(vertex, weight)| json!([vertex, rounded(f64::from(*weight))]));
        (name, pairs.collect::<Value>())
    });
    object([("weights", Value::Object(lists.collect()))])
}

/// What loading changed.
pub fn load_json(weights: &NamedWeights) -> Map<String, Value> {
    let loaded = &weights.loaded;
    let lost = loaded.lost.iter().filter(|share| **share > 0.0).count();
    let worst = (0_usize..)
        .zip(&loaded.lost)
        .filter(|(_, share)| **share > 0.0)
        .max_by(|a, b| a.1.total_cmp(b.1));
    let off = |sum: &&f32| (**sum - 1.0).abs() > 1e-4;
    object([
        (
            "vertices_not_summing_to_one",
            Value::from(loaded.raw_sums.iter().filter(off).count()),
        ),
        ("vertices_to_root", Value::from(loaded.root_vertices.len())),
        ("vertices_losing_weight", Value::from(lost)),
        (
            "largest_loss",
            worst.map_or(
                Value::Null,
                |(vertex, share)| json!({ "vertex": vertex, "share": rounded(f64::from(*share)) }),
            ),
        ),
    ])
}

/// What a reduction to fewer bones a vertex did.
pub fn reduction_json(reduction: &Reduction, limit: usize) -> Value {
    let worst = reduction
        .worst
        .map(|(vertex, share)| json!({ "vertex": vertex, "share": rounded(f64::from(share)) }));
    json!({
        "max_influences": limit, "most_before": reduction.most,
        "vertices_reduced": reduction.reduced.len(), "worst": worst,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seven_digits_and_no_negative_zero() {
        assert_eq!(rounded(12.345_678_91).to_string(), "12.34568");
        assert_eq!(rounded(-0.0).to_string(), "0.0");
        assert_eq!(rounded(-1e-30).to_string(), "-1e-30");
        assert_eq!(rounded(f64::NAN), Value::Null);
    }
}
