//! `mhlint eval fit`.

use std::io::Write;
use std::path::Path;

use serde_json::{Map, Value};

use super::args::{Attached, FitArgs, SettingArgs};
use super::{document, open_root, write};
use crate::cli::exit::Failure;
use crate::evaluate::makehuman2::read_asset;
use crate::evaluate::{Error, Point, fit_json, object, read_positions, read_text, with_positions};

pub(super) fn run(args: &FitArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let asset = read_asset(&args.file)?;
    let meshes = meshes(&args.base_mesh, &args.setting)?;
    let measured = if args.attached == Attached::Before { &meshes.plain } else { &meshes.morphed };
    let fitted = asset.fit(&meshes.morphed, measured, asset.is_proxy())?;
    let obj = || Ok(with_positions(&read_text(&asset.obj_path)?, &fitted.positions));
    let json = || {
        let mut inputs = meshes.inputs.clone();
        let attached = if args.attached == Attached::Before { "before the morph" } else { "after the morph" };
        inputs.extend(object([("file", Value::from(asset.path.as_str())), ("attached", Value::from(attached))]));
        Ok(document("fit", inputs, fit_json(&fitted, &args.output.vertices)?))
    };
    write::write_mesh(&args.output, obj, json, out)
}

/// The base mesh without and with its setting.
struct Meshes {
    plain: Vec<Point>,
    morphed: Vec<Point>,
    inputs: Map<String, Value>,
}

fn meshes(base: &Path, setting: &SettingArgs) -> Result<Meshes, Error> {
    if base.is_file() {
        if !setting.set.is_empty() || setting.settings.is_some() {
            let reason = "an OBJ file has no sliders; use a data folder as `--base-mesh` to set them".to_owned();
            return Err(Error::Input(reason));
        }
        let plain = read_positions(base)?;
        let inputs = object([("base_mesh", Value::from(base.to_string_lossy()))]);
        return Ok(Meshes { morphed: plain.clone(), plain, inputs });
    }
    let mut opened = open_root(base, setting)?;
    let morphed = opened.evaluation.morphed(&opened.setting)?;
    Ok(Meshes { plain: opened.evaluation.scene().positions.clone(), morphed, inputs: opened.inputs })
}
