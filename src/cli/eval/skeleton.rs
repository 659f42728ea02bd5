//! `mhlint eval skeleton`.

use std::io::Write;

use serde_json::Value;

use super::args::SkeletonArgs;
use super::{document, open, write};
use crate::cli::exit::Failure;
use crate::evaluate::{read_skeleton, skeleton_json};

pub(super) fn run(args: &SkeletonArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let skeleton = match &args.skeleton {
        Some(file) => read_skeleton(file)?,
        None => opened.evaluation.pose_skeleton()?.clone(),
    };
    let rest = opened.evaluation.rest(&skeleton, &positions)?;
    opened.inputs.insert("rig".to_owned(), Value::from(skeleton.path));
    write::write(&document("skeleton", opened.inputs, skeleton_json(&rest)), None, out)
}
