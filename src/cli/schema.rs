//! `mhlint schema`: the embedded schemas, for editors.

use std::io::Write;

use super::args::not_one_of;
use super::exit::{Exit, Failure};

/// The schemas by name.
const SCHEMAS: [(&str, &str); 9] = [
    ("base", include_str!("../../schemas/base.schema.json")),
    ("config", include_str!("../../schemas/config.schema.json")),
    ("geometry", include_str!("../../schemas/geometry.schema.json")),
    ("macro", include_str!("../../schemas/macro.schema.json")),
    ("mhskel", include_str!("../../schemas/mhskel.schema.json")),
    ("mhw", include_str!("../../schemas/mhw.schema.json")),
    ("modelling", include_str!("../../schemas/modelling.schema.json")),
    ("report", include_str!("../../schemas/report.schema.json")),
    ("target_cat", include_str!("../../schemas/target_cat.schema.json")),
];

fn schema_names() -> impl Iterator<Item = &'static str> {
    SCHEMAS.iter().map(|(name, _)| *name)
}

fn schema_text(name: &str) -> Option<&'static str> {
    SCHEMAS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

pub(super) fn run(name: Option<&str>, out: &mut dyn Write) -> Result<Exit, Failure> {
    let Some(name) = name else {
        for name in schema_names() {
            writeln!(out, "{name}")?;
        }
        return Ok(Exit::Clean);
    };
    let known: Vec<&str> = schema_names().collect();
    let text = schema_text(name).ok_or_else(|| Failure::Usage(not_one_of("schema", name, &known)))?;
    writeln!(out, "{}", text.trim_end())?;
    Ok(Exit::Clean)
}
