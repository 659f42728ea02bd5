//! Batches of cases as in the reference files: read, computed, printed or compared.
//!
//! A file has a `kind` and `cases`, each with `inputs` and `outputs`. One case that cannot be computed does not
//! keep the others from it.

mod compare;
mod compute;
mod inputs;
mod roots;
mod tolerance;

use serde_json::{Map, Value};

pub use compare::{Comparison, Deviation};
pub use roots::Roots;

use super::error::Error;
use super::files;
use crate::json::{Document, Node};
use inputs::File;

/// A file of cases with what came out.
#[derive(Debug)]
pub struct CaseRun<'t> {
    text: &'t [u8],
    document: Document,
    /// The cases in the order of the file.
    pub reports: Vec<CaseReport>,
}

/// What came out of a case.
#[derive(Debug)]
pub struct CaseReport {
    /// Base and name, for messages.
    pub name: String,
    /// Its outputs. Where the application stops they hold the name of the exception as `error`.
    pub outputs: Result<Map<String, Value>, Error>,
    /// What a reader should know besides.
    pub notes: Vec<String>,
}

/// Computes every case of a file. `path` is for messages.
///
/// # Errors
/// No JSON, no cases, or a kind that is not computed here.
pub fn run_cases<'t>(path: &str, text: &'t [u8], roots: &Roots) -> Result<CaseRun<'t>, Error> {
    let document = files::document(text).map_err(|reason| Error::file(path, reason))?;
    let reports = {
        let file = File::new(path, &document.root)?;
        let mut computer = compute::Computer::new(roots, &file)?;
        if file.cases.is_empty() {
            return Err(Error::file(path, "there is no case in `cases`"));
        }
        file.cases.iter().map(|case| report(&mut computer, case)).collect()
    };
    Ok(CaseRun { text, document, reports })
}

fn report(computer: &mut compute::Computer<'_>, case: &Node) -> CaseReport {
    let mut notes = Vec::new();
    let outputs = match computer.outputs(case, &mut notes) {
        Err(Error::Stops { exception, reason }) => {
            notes.push(reason);
            Ok(super::object([("error", Value::from(exception))]))
        }
        other => other,
    };
    CaseReport { name: inputs::title(case), outputs, notes }
}

impl CaseRun<'_> {
    /// The file with these outputs in place of its own; everything else is kept byte by byte.
    pub fn printed(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(self.text.len());
        let mut from = 0;
        for (case, report) in inputs::cases(&self.document.root).iter().zip(&self.reports) {
            let outputs = match &report.outputs {
                Ok(outputs) => outputs.clone(),
                Err(error) => super::object([("error", Value::from(error.to_string()))]),
            };
            let text = Value::Object(outputs).to_string();
            let (to, next, text) = match case.get("outputs") {
                Some(old) => (old.span.start, old.span.end, text),
                None if case.is_object() => {
                    let comma = if case.members().is_empty() { "" } else { "," };
                    let end = case.span.end.saturating_sub(1);
                    (end, end, format!("{comma}\"outputs\":{text}"))
                }
                None => continue,
            };
            out.extend_from_slice(self.text.get(from..to).unwrap_or_default());
            out.extend_from_slice(text.as_bytes());
            from = next;
        }
        out.extend_from_slice(self.text.get(from..).unwrap_or_default());
        out
    }

    /// Every case against the outputs that are in the file.
    pub fn compared(&self) -> Vec<Comparison> {
        let kind = self.document.root.get("kind").and_then(Node::as_str).unwrap_or_default();
        let cases = inputs::cases(&self.document.root).iter().zip(&self.reports);
        cases.map(|(case, report)| compare::compare(kind, case, report)).collect()
    }
}
