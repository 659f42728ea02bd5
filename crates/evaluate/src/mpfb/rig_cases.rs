//! Cases on rigs, weights, poses and assets of MPFB.

use std::path::PathBuf;

use serde_json::{Map, Value};

use super::asset::{Asset, FittedAsset, read_asset};
use super::cases::{details, settings};
use super::keys::Keys;
use super::pose::{read_stored_pose, stored_pose};
use super::rig::{RigFile, StandingRig, read_rig, roll_of, stops};
use super::weights::{existing, groups_json, inline, lists_json, read_groups};
use crate::Error;
use crate::cases::{Computer, inputs};
use crate::outputs::{mesh_json, object, rounded};
use mhlint_eval::mpfb::fit::interpolated;
use mhlint_eval::mpfb::groups::{FileGroup, Loading, Taker, Takers, load};
use mhlint_eval::mpfb::rest::Defined;
use mhlint_eval::vector::{Point, Vec3, round_to_f32};
use mhlint_formats::{mhclo::mpfb::in_order, obj};
use mhlint_json::{Node, Value as Json};

type Outputs = Map<String, Value>;

/// The mesh of a case, and the scale of one unit of the OBJ.
fn figure(
    of: &mut Computer<'_>,
    case: &Node,
    with_refit: bool,
) -> Result<(Vec<Point>, f64), Error> {
    let scale = inputs::field(case, "scale_factor")
        .and_then(Node::as_f64)
        .unwrap_or(0.1);
    let mut targets = details(case, "targets")?;
    if with_refit {
        targets.extend(details(case, "refit_targets")?);
    }
    let given = inputs::field(case, "macro").filter(|node| !matches!(node.value, Json::Null));
    let given = given.map(settings).transpose()?;
    let base = of.base(case)?;
    let mut keys = Keys::default();
    if let Some(values) = given {
        let setting = base.setting(&values)?;
        keys.set_macros(base, &setting)?;
    }
    for (target, value) in targets {
        keys.add(base, &target, value);
    }
    Ok((keys.mixed(base, round_to_f32(scale))?, scale))
}

/// A file of MPFB itself, unless the name says whose it is.
fn file(of: &Computer<'_>, written: &str) -> Result<PathBuf, Error> {
    let is_own = written.starts_with("data/") && !written.ends_with(')');
    of.roots.file(&if is_own {
        format!("{written} (mpfb)")
    } else {
        written.to_owned()
    })
}

fn rig_of(of: &Computer<'_>, case: &Node) -> Result<RigFile, Error> {
    read_rig(&file(of, inputs::text(case, "rig")?)?)
}

fn standing(of: &mut Computer<'_>, case: &Node, rig: &RigFile) -> Result<StandingRig, Error> {
    let (positions, scale) = figure(of, case, true)?;
    let base = of.base(case)?;
    rig.stand(&base.joints(&positions), scale)
}

/// `mpfb_rig`: heads and tails.
pub(super) fn rig(
    of: &mut Computer<'_>,
    case: &Node,
    _: &mut Vec<String>,
) -> Result<Outputs, Error> {
    let rig = rig_of(of, case)?;
    let rig = standing(of, case, &rig)?;
    Ok(object([
        ("relative_scale", rounded(rig.relative_scale)),
        ("bones", rig.ends_json()),
        ("strategies", rig.strategies_json()),
        ("default_position_used", Value::from(rig.at_default.clone())),
    ]))
}

/// `mpfb_bones`: bones at rest.
pub(super) fn bones(
    of: &mut Computer<'_>,
    case: &Node,
    _: &mut Vec<String>,
) -> Result<Outputs, Error> {
    if let Some(definition) = inputs::field(case, "definition") {
        let rig = synthetic(definition)?;
        return Ok(object([
            ("bones", rig.json()),
            ("missing", Value::from(Vec::<Value>::new())),
        ]));
    }
    let rig = rig_of(of, case)?;
    let rig = standing(of, case, &rig)?;
    Ok(object([
        ("relative_scale", rounded(rig.relative_scale)),
        // An armature is made where its figure is.
        (
            "armature_location",
            Value::from([0.0; 3].map(rounded).to_vec()),
        ),
        ("identified", Value::from(rig.identified())),
        ("bones", rig.json()),
    ]))
}

/// Bones whose ends are given.
fn synthetic(definition: &Node) -> Result<StandingRig, Error> {
    let members = definition.effective_members();
    let names: Vec<String> = members.iter().map(|member| member.key.clone()).collect();
    let bone = |node: &Node| {
        let text = |key| node.get(key).and_then(Node::as_str);
        let angle = node.get("roll").and_then(Node::as_f64).unwrap_or(0.0);
        let roll = roll_of(
            text("roll_strategy"),
            node.get("roll_reference_z").and_then(place),
            angle,
        );
        Some(Defined {
            head: node.get("head").and_then(place)?,
            tail: node.get("tail").and_then(place)?,
            roll,
            parent: text("parent").and_then(|parent| names.iter().position(|name| name == parent)),
            use_connect: matches!(
                node.get("use_connect").map(|node| &node.value),
                Some(Json::Bool(true))
            ),
        })
    };
    let defined: Option<Vec<Defined>> = members.iter().map(|member| bone(&member.node)).collect();
    let wrong =
        || Error::Input("a bone of the case has no `head` and `tail` of three numbers".to_owned());
    StandingRig::of_places(names.clone(), &defined.ok_or_else(wrong)?)
}

fn place(node: &Node) -> Option<Vec3> {
    match node.elements() {
        [x, y, z] => Some([x.as_f64()?, y.as_f64()?, z.as_f64()?]),
        _ => None,
    }
}

/// `mpfb_weights`: vertex groups.
pub(super) fn weights(
    of: &mut Computer<'_>,
    case: &Node,
    _: &mut Vec<String>,
) -> Result<Outputs, Error> {
    if inputs::field(case, "bones").is_some() {
        return synthetic_weights(case);
    }
    let rig = rig_of(of, case)?;
    let lists = read_groups(&file(of, inputs::text(case, "weights")?)?)?;
    let ids = inputs::vertex_ids(of.file, case, "")?;
    let vertices = of.base(case)?.scene().positions.len();
    Ok(groups_json(&rig.groups(&lists, vertices), &ids))
}

fn synthetic_weights(case: &Node) -> Result<Outputs, Error> {
    let is_set = |key: &str| {
        matches!(
            inputs::field(case, key).map(|node| &node.value),
            Some(Json::Bool(true))
        )
    };
    let bones = inputs::wanted(case, "bones")?.elements();
    let taker = |node: &'_ Node| -> Option<(String, Option<String>, bool)> {
        let deforms = !matches!(
            node.get("deform").map(|node| &node.value),
            Some(Json::Bool(false))
        );
        let parent = node.get("parent").and_then(Node::as_str).map(str::to_owned);
        Some((node.get("name")?.as_str()?.to_owned(), parent, deforms))
    };
    let bones: Vec<(String, Option<String>, bool)> = bones.iter().filter_map(taker).collect();
    let bones = bones.iter().map(|(name, parent, deforms)| Taker {
        name,
        parent: parent.as_deref(),
        deforms: *deforms,
    });
    let extra = inputs::field(case, "extra_bones")
        .map(Node::elements)
        .unwrap_or_default();
    let takers = Takers::new(bones, extra.iter().filter_map(Node::as_str));
    let lists = inline(inputs::wanted(case, "weights")?)?;
    let file: Vec<FileGroup<'_>> = lists
        .iter()
        .map(|(name, pairs)| (name.as_str(), pairs.as_slice()))
        .collect();
    let before = inputs::field(case, "existing")
        .map(inline)
        .transpose()?
        .unwrap_or_default();
    let vertices = inputs::count(case, "vertex_count")?;
    let loading = Loading {
        all: is_set("all"),
        replace: is_set("replace"),
        vertices,
    };
    if file
        .iter()
        .flat_map(|(_, pairs)| *pairs)
        .any(|(vertex, _)| *vertex > i64::from(i32::MAX))
    {
        return Err(stops(
            "SystemError",
            "a vertex does not fit into 31 bits".to_owned(),
        ));
    }
    Ok(lists_json(&load(existing(before), &file, &takers, loading)))
}

/// `mpfb_fit`: assets on a figure, and the weights that they take from it.
pub(super) fn fit(
    of: &mut Computer<'_>,
    case: &Node,
    _: &mut Vec<String>,
) -> Result<Outputs, Error> {
    let text = inputs::field(case, "mhclo").and_then(Node::as_str);
    let is_synthetic = text.is_some();
    let asset = match text {
        Some(text) => {
            let mesh = obj::parse(inputs::text(case, "obj")?.as_bytes());
            Asset::of(
                "the case".to_owned(),
                PathBuf::new(),
                in_order::read(text.as_bytes()),
                &mesh,
            )?
        }
        None => read_asset(&file(of, inputs::text(case, "file")?)?)?,
    };
    let ids = inputs::vertex_ids(of.file, case, "")?;
    if inputs::field(case, "rig").is_some() {
        return taken_weights(of, case, &asset, &ids);
    }
    let (mesh, scale) = figure(of, case, false)?;
    let fitted = asset.fit(&mesh, of.base(case)?, scale)?;
    let all: Vec<i64> = (0..).take(fitted.positions.len()).collect();
    let mut outputs = asset.outputs(&fitted, if is_synthetic { &all } else { &ids })?;
    let FittedAsset { hidden, .. } = fitted;
    outputs.insert("delete_list".to_owned(), Value::from(hidden));
    Ok(outputs)
}

fn taken_weights(
    of: &mut Computer<'_>,
    case: &Node,
    asset: &Asset,
    ids: &[i64],
) -> Result<Outputs, Error> {
    let rig = rig_of(of, case)?;
    let lists = read_groups(&file(of, inputs::text(case, "weights")?)?)?;
    let vertices = of.base(case)?.scene().positions.len();
    let groups = interpolated(asset.rows(), &rig.groups(&lists, vertices));
    let mut outputs = groups_json(&groups, ids);
    outputs.insert("vertex_count".to_owned(), Value::from(asset.rows().len()));
    Ok(outputs)
}

/// `mpfb_pose`: stored poses on a rig.
pub(super) fn pose(
    of: &mut Computer<'_>,
    case: &Node,
    _: &mut Vec<String>,
) -> Result<Outputs, Error> {
    let pose = match inputs::field(case, "pose") {
        Some(node) => stored_pose(node)?,
        None => read_stored_pose(&file(of, inputs::text(case, "pose_file")?)?)?,
    };
    let rig = rig_of(of, case)?;
    let (mesh, scale) = figure(of, case, false)?;
    let vertices = mesh.len();
    let standing = rig.stand(&of.base(case)?.joints(&mesh), scale)?;
    let posed = standing.posed(&pose)?;
    let chosen = case.get("outputs").and_then(|outputs| outputs.get("bones"));
    let chosen = chosen.map(|bones| {
        bones
            .members()
            .iter()
            .map(|bone| bone.key.clone())
            .collect::<Vec<_>>()
    });
    let bones = standing.posed_json(&posed, chosen.as_deref());
    let Some(weights) = inputs::field(case, "weights").and_then(Node::as_str) else {
        return Ok(object([("bones", bones)]));
    };
    let groups = rig.groups(&read_groups(&file(of, weights)?)?, vertices);
    let moved = standing.skinned(&mesh, &posed, &groups);
    let mut outputs = mesh_json(&moved, &inputs::vertex_ids(of.file, case, "")?)?;
    outputs.insert("bones".to_owned(), bones);
    Ok(outputs)
}
