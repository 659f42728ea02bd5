//! What `mhlint eval` shows of MPFB: rigs on a figure, weights as vertex groups, poses, and assets.
//!
//! Numbers are those of Blender: metres, z up. An OBJ has the axes and units of `base.obj`.

use std::io::Write;
use std::path::Path;

use serde_json::Value;

use super::args::{FitArgs, RigArgs, RigChoice, SkinArgs};
use super::{Opened, document, open, open_root, write};
use crate::cli::exit::Failure;
use mhlint_eval::vector::round_to_f32;
use mhlint_evaluate::mpfb::{
    RigFile, StandingRig, groups_json, read_asset, read_groups, read_rig, read_stored_pose,
};
use mhlint_evaluate::{Error, Point, object, read_text, with_positions};

/// A figure with a rig on it.
struct Rigged {
    opened: Opened,
    positions: Vec<Point>,
    rig: RigFile,
    standing: StandingRig,
}

/// `mhlint eval rig`.
pub(super) fn rig(args: &RigArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let Rigged {
        opened, standing, ..
    } = rigged(open(&args.base)?, &args.choice)?;
    write::write(
        &document("rig", opened.inputs, standing.outputs()),
        None,
        out,
    )
}

fn rigged(mut opened: Opened, choice: &RigChoice) -> Result<Rigged, Error> {
    let missing = || Error::Input("no rig is given; use `--rig FILE`".to_owned());
    let rig = read_rig(choice.rig.as_deref().ok_or_else(missing)?)?;
    let positions = figure(&mut opened, choice.scale)?;
    let standing = rig.stand(&opened.evaluation.joints(&positions), choice.scale)?;
    opened.inputs.extend(object([
        ("rig", Value::from(rig.path.as_str())),
        ("scale_factor", Value::from(choice.scale)),
    ]));
    Ok(Rigged {
        opened,
        positions,
        rig,
        standing,
    })
}

/// The figure at its setting.
fn figure(opened: &mut Opened, scale: f64) -> Result<Vec<Point>, Error> {
    if !(scale.is_finite() && scale > 0.0) {
        return Err(Error::Input(format!(
            "`--scale {scale}` is not a number above 0"
        )));
    }
    opened
        .evaluation
        .in_blender(&opened.setting, round_to_f32(scale))
}

/// `mhlint eval weights --rig`.
pub(super) fn weights(
    file: &Path,
    rig: &Path,
    vertices: Option<usize>,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (rig, lists) = (read_rig(rig)?, read_groups(file)?);
    let named = lists
        .iter()
        .flat_map(|(_, pairs)| pairs)
        .map(|(vertex, _)| vertex.saturating_add(1))
        .max();
    let named = named
        .and_then(|count| usize::try_from(count).ok())
        .unwrap_or(0);
    let count = vertices.unwrap_or(named);
    let mut outputs = groups_json(&rig.groups(&lists, count), &[]);
    outputs.remove("vertices");
    let inputs = object([
        ("file", Value::from(file.to_string_lossy())),
        ("rig", Value::from(rig.path)),
        ("vertex_count", Value::from(count)),
    ]);
    write::write(&document("weights", inputs, outputs), None, out)
}

/// `mhlint eval skin --rig`.
pub(super) fn skin(args: &SkinArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let pose = read_stored_pose(&args.pose)?;
    let Rigged {
        mut opened,
        positions,
        rig,
        standing,
    } = rigged(open(&args.base)?, &args.choice)?;
    let missing = || Error::Input("no weights are given; use `--weights FILE`".to_owned());
    let lists = read_groups(args.weights.as_deref().ok_or_else(missing)?)?;
    let posed = standing.posed(&pose)?;
    let moved = standing.skinned(&positions, &posed, &rig.groups(&lists, positions.len()));
    opened
        .inputs
        .insert("pose".to_owned(), Value::from(args.pose.to_string_lossy()));
    let obj = || {
        Ok(with_positions(
            &opened.evaluation.mesh_text()?,
            &as_in_obj(&moved, args.choice.scale),
        ))
    };
    let json = || {
        let outputs = standing.posed_outputs(&posed, &moved, &args.output.vertices)?;
        Ok(document("skin", opened.inputs.clone(), outputs))
    };
    write::write_mesh(&args.output, obj, json, out)
}

/// `mhlint eval fit --app mpfb`.
pub(super) fn fit(args: &FitArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let asset = read_asset(&args.file)?;
    if args.base_mesh.is_file() {
        return Err(Error::Input(
            "MPFB needs its data folder as `--base-mesh`, not an OBJ file".to_owned(),
        )
        .into());
    }
    let mut opened = open_root(&args.base_mesh, &args.setting)?;
    let mesh = figure(&mut opened, args.scale)?;
    let fitted = asset.fit(&mesh, &opened.evaluation, args.scale)?;
    let obj = || {
        let all = asset.on_obj(&fitted, |point| {
            as_in_obj(&[point], args.scale)
                .first()
                .copied()
                .unwrap_or(point)
        })?;
        Ok(with_positions(&read_text(&asset.obj_path)?, &all))
    };
    let json = || {
        let mut inputs = opened.inputs.clone();
        inputs.extend(object([
            ("file", Value::from(asset.path.as_str())),
            ("scale_factor", Value::from(args.scale)),
        ]));
        Ok(document(
            "fit",
            inputs,
            asset.outputs(&fitted, &args.output.vertices)?,
        ))
    };
    write::write_mesh(&args.output, obj, json, out)
}

/// Points of Blender in the axes and units of an OBJ of MakeHuman.
fn as_in_obj(points: &[Point], scale: f64) -> Vec<Point> {
    let scale = round_to_f32(scale);
    points
        .iter()
        .map(|[x, y, z]| [x / scale, z / scale, -y / scale])
        .collect()
}
