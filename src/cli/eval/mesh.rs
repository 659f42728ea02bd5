//! `mhlint eval mesh`.

use std::io::Write;

use super::args::MeshArgs;
use super::{document, open, write};
use crate::cli::exit::Failure;
use crate::evaluate::{mesh_json, with_positions};

pub(super) fn run(args: &MeshArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut opened = open(&args.base)?;
    let positions = opened.evaluation.morphed(&opened.setting)?;
    let obj = || Ok(with_positions(&opened.evaluation.mesh_text()?, &positions));
    let json = || Ok(document("mesh", opened.inputs, mesh_json(&positions, &args.output.vertices)?));
    write::write_mesh(&args.output, obj, json, out)
}
