//! `mhlint schema`: the embedded schemas, for editors.

use std::io::Write;

use super::exit::{Exit, Failure};
use super::one_of::not_one_of;
use mhlint_json::{schema_names, schema_text};

pub(super) fn run(name: Option<&str>, out: &mut dyn Write) -> Result<Exit, Failure> {
    let Some(name) = name else {
        for name in schema_names() {
            writeln!(out, "{name}")?;
        }
        return Ok(Exit::Clean);
    };
    let known: Vec<&str> = schema_names().collect();
    let text =
        schema_text(name).ok_or_else(|| Failure::Usage(not_one_of("schema", name, &known)))?;
    writeln!(out, "{}", text.trim_end())?;
    Ok(Exit::Clean)
}
