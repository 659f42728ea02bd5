//! `mhlint eval macros`.

use std::io::Write;

use super::args::MacrosArgs;
use super::{document, open, write};
use crate::cli::exit::Failure;
use crate::evaluate::macros_json;

pub(super) fn run(args: &MacrosArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let opened = open(&args.base)?;
    let (table, result) = opened.evaluation.macros(&opened.setting)?;
    let outputs = macros_json(&opened.evaluation, table, &result);
    write::write(&document("macros", opened.inputs, outputs), None, out)
}
