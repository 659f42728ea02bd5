//! `mhlint eval fit`.

use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value};

use super::args::{Attached, FitArgs, FittedBy, SettingArgs};
use super::{document, mpfb, open_root, write};
use crate::cli::exit::Failure;
use mhlint_evaluate::{
    Error, Fitted, Point, fit_json, makehuman1, makehuman2, object, read_positions, read_text,
    with_positions,
};

pub(super) fn run(args: &FitArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.app == FittedBy::Mpfb {
        return mpfb::fit(args, out);
    }
    let Done {
        fitted,
        path,
        obj_path,
        inputs,
    } = match args.app {
        FittedBy::Makehuman1 => by_makehuman1(args)?,
        FittedBy::Makehuman2 | FittedBy::Mpfb => by_makehuman2(args)?,
    };
    let obj = || Ok(with_positions(&read_text(&obj_path)?, &fitted.positions));
    let json = || {
        let mut inputs = inputs;
        let attached = if args.attached == Attached::Before {
            "before the morph"
        } else {
            "after the morph"
        };
        inputs.extend(object([
            ("file", Value::from(path)),
            ("attached", Value::from(attached)),
        ]));
        Ok(document(
            "fit",
            inputs,
            fit_json(&fitted, &args.output.vertices)?,
        ))
    };
    write::write_mesh(&args.output, obj, json, out)
}

/// An asset on the mesh that was asked for.
struct Done {
    fitted: Fitted,
    path: String,
    obj_path: PathBuf,
    inputs: Map<String, Value>,
}

fn by_makehuman2(args: &FitArgs) -> Result<Done, Error> {
    let asset = makehuman2::read_asset(&args.file)?;
    let meshes = meshes(&args.base_mesh, &args.setting)?;
    let measured = if args.attached == Attached::Before {
        &meshes.plain
    } else {
        &meshes.morphed
    };
    let fitted = asset.fit(&meshes.morphed, measured, asset.is_proxy())?;
    Ok(Done {
        fitted,
        path: asset.path,
        obj_path: asset.obj_path,
        inputs: meshes.inputs,
    })
}

fn by_makehuman1(args: &FitArgs) -> Result<Done, Error> {
    let asset = makehuman1::read_asset(&args.file)?;
    if !args.setting.set.is_empty() || args.setting.settings.is_some() {
        let reason = "the sliders of MakeHuman 1 cannot be set yet; without `--set` its base mesh \
            is used as it is";
        return Err(Error::Input(reason.to_owned()));
    }
    let base = &args.base_mesh;
    let inside = ["3dobjs/base.obj", "data/3dobjs/base.obj"].map(|rel| base.join(rel));
    let mesh = if base.is_file() {
        Some(base)
    } else {
        inside.iter().find(|mesh| mesh.is_file())
    };
    let no_mesh = || {
        Error::Input(format!(
            "`{}` contains no `3dobjs/base.obj`",
            base.display()
        ))
    };
    let mesh = mesh.ok_or_else(no_mesh)?;
    let fitted = asset.fit(&read_positions(mesh)?)?;
    let inputs = object([("base_mesh", Value::from(mesh.to_string_lossy()))]);
    Ok(Done {
        fitted,
        path: asset.path,
        obj_path: asset.obj_path,
        inputs,
    })
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
            let reason =
                "an OBJ file has no sliders; use a data folder as `--base-mesh` to set them"
                    .to_owned();
            return Err(Error::Input(reason));
        }
        let plain = read_positions(base)?;
        let inputs = object([("base_mesh", Value::from(base.to_string_lossy()))]);
        return Ok(Meshes {
            morphed: plain.clone(),
            plain,
            inputs,
        });
    }
    let mut opened = open_root(base, setting)?;
    let morphed = opened.evaluation.morphed(&opened.setting)?;
    Ok(Meshes {
        plain: opened.evaluation.scene().positions.clone(),
        morphed,
        inputs: opened.inputs,
    })
}
