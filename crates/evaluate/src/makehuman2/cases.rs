//! What each kind of case of MakeHuman 2 computes.

use std::path::Path;

use serde_json::{Map, Value};

use super::asset::read_asset;
use super::skeleton::{read_skeleton, read_skeleton_with_joints};
use super::stops;
use super::weights::{MOST_VERTICES, WeightLists, read_weights, transferred};
use crate::cases::tolerance::{
    FACTORS, FITTED, JOINTS, MORPHED, REST_MATRICES, SKINNED, Tolerance, WEIGHTS,
};
use crate::cases::{Compute, Computer, Kind, inputs, morphed, setting, use_of};
use crate::outputs::{
    fit_json, mesh_json, skeleton_json, skin_json, weight_lists_json, weights_json,
};
use crate::{Error, pose};
use mhlint_diag::Application;
use mhlint_formats::mhw;
use mhlint_json::{Node, Value as Json};

type Outputs = Map<String, Value>;

/// The kinds that the reference files of MakeHuman 2 have.
pub(crate) static KINDS: [Kind; 7] = [
    Kind {
        tolerances: &[("sum", FACTORS)],
        ..kind("mh2_macro_weights", macros, FACTORS)
    },
    kind("mh2_morph", morph, MORPHED),
    Kind {
        tolerances: &[("matRestGlobal", REST_MATRICES)],
        ..kind("mh2_joints", joints, JOINTS)
    },
    Kind {
        by_bone: true,
        ..kind("mh2_weights", weights, WEIGHTS)
    },
    Kind {
        by_bone: true,
        ..kind("mh2_weights_transfer", transfer, WEIGHTS)
    },
    kind("mh2_skinning", skinning, SKINNED),
    kind("mh2_fit", fit, FITTED),
];

/// Whose cases these are.
const OWN: Application = Application::Makehuman2;

const fn kind(name: &'static str, outputs: Compute, tolerance: Tolerance) -> Kind {
    Kind {
        name,
        application: OWN,
        outputs,
        tolerance,
        tolerances: &[],
        by_bone: false,
    }
}

fn macros(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let modifiers = inputs::modifiers(case)?.unwrap_or_default();
    let base = of.base(case)?;
    let setting = setting(base, &modifiers, notes);
    let (table, result) = base.macros(&setting)?;
    Ok(base.macro_outputs(table, &result))
}

fn morph(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let (file, modifiers) = (of.file, inputs::modifiers(case)?);
    let base = of.base(case)?;
    let positions = morphed(base, modifiers, notes)?;
    let mut outputs = mesh_json(&positions, &inputs::vertex_ids(file, case, base.base())?)?;
    outputs.insert("bbox_upstream".to_owned(), base.visible_box(&positions));
    Ok(outputs)
}

fn joints(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let rig = of.roots.file(inputs::text(case, "rig")?)?;
    let modifiers = inputs::modifiers(case)?;
    let base = of.base(case)?;
    let positions = morphed(base, modifiers, notes)?;
    Ok(skeleton_json(
        &base.rest(&read_skeleton(&rig)?, &positions)?,
    ))
}

fn weights(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let root = inputs::text(case, "root")?;
    let count = inputs::count(case, "vertex_count")?;
    of.work += count.min(MOST_VERTICES);
    if let Some(lists) = inputs::field(case, "weights").filter(|lists| lists.as_str().is_none()) {
        return Ok(weight_lists_json(
            &inline_weights(lists)?.load(root, count)?,
        ));
    }
    let written = inputs::text(case, "file")?;
    let path = of.roots.file(written)?;
    let weights = if is_asset(&path) {
        let asset = read_asset(&path)?;
        // Assets of MakeHuman 2 lie in a folder of their base; others say nothing about it.
        let named = inputs::field(case, "base")
            .and_then(Node::as_str)
            .map(str::to_owned);
        let base = named.or_else(|| use_of(written, OWN)?.owner);
        asset.derived_weights(of.base_called(base.as_deref())?, root)?
    } else {
        read_weights(&path)?.load(root, count)?
    };
    let mut outputs = weights_json(
        &weights,
        &weights.influences(count)?,
        &inputs::weighted_vertices(case),
    );
    outputs.remove("vertex_sum_range");
    Ok(outputs)
}

fn transfer(of: &mut Computer<'_>, case: &Node, _: &mut Vec<String>) -> Result<Outputs, Error> {
    let other = read_skeleton_with_joints(&of.roots.file(inputs::text(case, "rig")?)?)?;
    let written = inputs::text(case, "weights")?;
    let path = of.roots.file(written)?;
    let named = inputs::field(case, "base")
        .and_then(Node::as_str)
        .map(str::to_owned);
    let base = of.base_called(named.or_else(|| use_of(written, OWN)?.owner).as_deref())?;
    let default = base.pose_skeleton()?.clone();
    let vertices = base.scene().positions.len();
    let count = if inputs::field(case, "vertex_count").is_some() {
        inputs::count(case, "vertex_count")?
    } else {
        vertices
    };
    of.work += count.min(MOST_VERTICES);
    let loaded = read_weights(&path)?.load(default.root()?, count)?;
    let (moved, _) = transferred(&loaded, &default, &other)?;
    Ok(weights_json(
        &moved,
        &moved.influences(count)?,
        &inputs::weighted_vertices(case),
    ))
}

fn skinning(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let (file, modifiers) = (of.file, inputs::modifiers(case)?);
    let poses = pose::poses(inputs::wanted(case, "poses")?).map_err(Error::Input)?;
    let base = of.base(case)?;
    let positions = morphed(base, modifiers, notes)?;
    skin_json(
        &base.posed(&positions, &poses)?,
        &inputs::vertex_ids(file, case, base.base())?,
    )
}

fn fit(of: &mut Computer<'_>, case: &Node, notes: &mut Vec<String>) -> Result<Outputs, Error> {
    let (file, modifiers) = (of.file, inputs::modifiers(case)?);
    let asset = read_asset(&of.roots.file(inputs::text(case, "file")?)?)?;
    let is_proxy = match inputs::field(case, "type").and_then(Node::as_str) {
        Some(category) => category == "proxy",
        None => asset.is_proxy(),
    };
    let attached = inputs::field(case, "attached")
        .and_then(Node::as_str)
        .unwrap_or("same mesh");
    let base = of.base(case)?;
    let positions = morphed(base, modifiers, notes)?;
    let measured = match attached {
        "before the morph" => base.scene().positions.as_slice(),
        "after the morph" | "same mesh" => positions.as_slice(),
        other => {
            return Err(Error::Input(format!(
                "`attached` is `{other}`; use `before the morph` or `after the morph`"
            )));
        }
    };
    let fitted = asset.fit(&positions, measured, is_proxy)?;
    let mut outputs = fit_json(&fitted, &inputs::vertex_ids(file, case, base.base())?)?;
    if attached != "same mesh" {
        // Counts do not depend on the mesh; the files give them once an asset, on the plain mesh.
        outputs.retain(|key, _| {
            !matches!(key.as_str(), "vertex_count" | "ref_count" | "delete_verts")
        });
    }
    Ok(outputs)
}

fn is_asset(path: &Path) -> bool {
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or_default();
    matches!(ending.to_ascii_lowercase().as_str(), "mhclo" | "proxy")
}

/// The `weights` object of a weights file that stands in the case itself.
pub(crate) fn inline_weights(node: &Node) -> Result<WeightLists, Error> {
    let stop = |exception, reason| Err(stops(exception, reason));
    if !node.is_object() {
        return stop("AttributeError", "`weights` is not an object".to_owned());
    }
    for member in node.effective_members() {
        if let Some((exception, reason)) = member.node.elements().iter().find_map(pair_fault) {
            return stop(exception, format!("bone `{}`: {reason}", member.key));
        }
        if !member.node.is_array() {
            return stop("TypeError", format!("bone `{}` has no list", member.key));
        }
    }
    let mut lists = WeightLists::default();
    for member in node.effective_members() {
        let pairs = (0..)
            .zip(member.node.elements())
            .filter_map(|(position, pair)| {
                let [vertex, weight] = pair.elements() else {
                    return None;
                };
                let weight = mhlint_eval::vector::round_to_f32(weight.as_f64()?);
                Some(mhw::Pair {
                    position,
                    vertex: vertex.as_i64()?,
                    weight,
                })
            });
        lists.bones.push((member.key.clone(), pairs.collect()));
    }
    Ok(lists)
}

/// What Python raises over a pair (`docs/loaders/makehuman2/weights.md#faults-of-weights`).
fn pair_fault(pair: &Node) -> Option<(&'static str, &'static str)> {
    match (pair.is_array(), pair.elements()) {
        (false, _) => Some(("TypeError", "an entry is not a pair")),
        (true, [vertex, weight]) => {
            if weight.as_f64().is_none() {
                Some(("TypeError", "a weight is not a number"))
            } else if matches!(
                vertex.value,
                Json::Null | Json::Array(_) | Json::Object(_) | Json::Bool(_)
            ) {
                Some(("TypeError", "a vertex is not a number"))
            } else if vertex.as_i64().is_none() {
                Some(("IndexError", "a vertex is not an integer"))
            } else {
                None
            }
        }
        (true, _) => Some(("ValueError", "an entry does not have two members")),
    }
}
