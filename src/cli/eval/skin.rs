//! `mhlint eval skin`.

use std::io::Write;

use serde_json::Value;

use super::args::SkinArgs;
use super::{document, open, write};
use crate::cli::exit::Failure;
use crate::evaluate::{read_poses, skin_json, with_positions};

pub(super) fn run(args: &SkinArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let poses = read_poses(&args.pose)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let skinned = opened.evaluation.posed(&positions, &poses)?;
    opened.inputs.insert("pose".to_owned(), Value::from(args.pose.to_string_lossy()));
    let obj = || Ok(with_positions(&opened.evaluation.mesh_text()?, &skinned.positions));
    let json = || Ok(document("skin", opened.inputs, skin_json(&skinned, &args.output.vertices)?));
    write::write_mesh(&args.output, obj, json, out)
}
