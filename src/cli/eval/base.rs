//! What `mhlint eval` shows of a base at a setting: its macros and modifiers, its mesh, a skeleton
//! on it, its mesh in a pose.

use std::io::Write;

use serde_json::Value;

use super::args::{BaseArgs, MeshArgs, SkeletonArgs, SkinArgs};
use super::{document, open, write};
use crate::cli::exit::Failure;
use mhlint_evaluate::makehuman2::read_skeleton;
use mhlint_evaluate::{mesh_json, read_poses, skeleton_json, skin_json, with_positions};

/// `mhlint eval macros`.
pub(super) fn macros(args: &BaseArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let opened = open(args)?;
    let outputs = opened.evaluation.macros_json(&opened.setting)?;
    write::write(&document("macros", opened.inputs, outputs), None, out)
}

/// `mhlint eval modifiers`.
pub(super) fn modifiers(args: &BaseArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let opened = open(args)?;
    let outputs = opened
        .evaluation
        .modifiers_json(&opened.setting, &opened.values)?;
    write::write(&document("modifiers", opened.inputs, outputs), None, out)
}

/// `mhlint eval mesh`.
pub(super) fn mesh(args: &MeshArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let obj = || Ok(with_positions(&opened.evaluation.mesh_text()?, &positions));
    let json = || {
        Ok(document(
            "mesh",
            opened.inputs,
            mesh_json(&positions, &args.output.vertices)?,
        ))
    };
    write::write_mesh(&args.output, obj, json, out)
}

/// `mhlint eval skeleton`.
pub(super) fn skeleton(args: &SkeletonArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let skeleton = match &args.skeleton {
        Some(file) => read_skeleton(file)?,
        None => opened.evaluation.pose_skeleton()?.clone(),
    };
    let rest = opened.evaluation.rest(&skeleton, &positions)?;
    opened
        .inputs
        .insert("rig".to_owned(), Value::from(skeleton.path));
    write::write(
        &document("skeleton", opened.inputs, skeleton_json(&rest)),
        None,
        out,
    )
}

/// `mhlint eval skin`.
pub(super) fn skin(args: &SkinArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let poses = read_poses(&args.pose)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let skinned = opened.evaluation.posed(&positions, &poses)?;
    opened
        .inputs
        .insert("pose".to_owned(), Value::from(args.pose.to_string_lossy()));
    let obj = || {
        Ok(with_positions(
            &opened.evaluation.mesh_text()?,
            &skinned.positions,
        ))
    };
    let json = || {
        Ok(document(
            "skin",
            opened.inputs,
            skin_json(&skinned, &args.output.vertices)?,
        ))
    };
    write::write_mesh(&args.output, obj, json, out)
}
