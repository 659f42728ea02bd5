//! Batches of cases as in the reference files: read, computed, printed or compared.
//!
//! A file has a `kind` and `cases`, each with `inputs` and `outputs`. One case that cannot be
//! computed does not keep the others from it.

mod compare;
mod computer;
pub(super) mod inputs;
mod roots;
pub(super) mod tolerance;

use serde_json::{Map, Value};

pub use compare::{Comparison, Deviation};
pub use computer::OpenBase;
pub(super) use computer::{Computer, morphed, setting};
pub use roots::Roots;
pub(super) use roots::use_of;

use super::error::Error;
use super::files;
use super::formulas::kinds;
use inputs::File;
use mhlint_diag::Application;
use mhlint_json::{Document, Node};
use tolerance::Tolerance;

/// Computes the outputs of a case; notes what a reader should know besides.
pub(super) type Compute =
    fn(&mut Computer<'_>, &Node, &mut Vec<String>) -> Result<Map<String, Value>, Error>;

/// Values of all outputs of a file; reference files have three thousand. A few names of vertices
/// that all cases share make any number of them.
const MOST_VALUES: usize = 1 << 20;
/// Vertices that a case is computed for and that cost as much as a value in its outputs.
const WORK_OF_A_VALUE: usize = 256;

/// A kind of case.
#[derive(Debug)]
pub(super) struct Kind {
    /// As files say it.
    pub(super) name: &'static str,
    /// Whose it is; the data of its bases lie in the folder of this one.
    pub(super) application: Application,
    pub(super) outputs: Compute,
    /// How far numbers may lie apart.
    pub(super) tolerance: Tolerance,
    /// Quantities with a tolerance of their own.
    pub(super) tolerances: &'static [(&'static str, Tolerance)],
    /// Whether `bones` has for each bone a number of entries and a sum.
    pub(super) by_bone: bool,
}

/// A file of cases with what came out.
#[derive(Debug)]
pub struct CaseRun<'t> {
    kind: &'static Kind,
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

/// Computes every case of a file. `path` is for messages, `open` opens the bases.
///
/// # Errors
/// No JSON, no cases, or a kind that is not computed here.
pub fn run_cases<'t>(
    path: &str,
    text: &'t [u8],
    roots: &Roots,
    open: OpenBase,
) -> Result<CaseRun<'t>, Error> {
    let document = files::document(text).map_err(|reason| Error::file(path, reason))?;
    let file = File::new(path, &document.root)?;
    let kind = kind_called(file.kind)?;
    if file.cases.is_empty() {
        return Err(Error::file(path, "its `cases` list is empty"));
    }
    let mut computer = Computer::new(kind, roots, &file, open);
    let mut room = MOST_VALUES;
    let reports = file.cases.iter().map(|case| {
        let report = if room > 0 {
            report(kind, &mut computer, case)
        } else {
            left_out(case)
        };
        room = room.saturating_sub(
            report.outputs.as_ref().map_or(0, values) + computer.work / WORK_OF_A_VALUE,
        );
        computer.work = 0;
        report
    });
    let reports = reports.collect();
    Ok(CaseRun {
        kind,
        text,
        document,
        reports,
    })
}

fn kind_called(name: &str) -> Result<&'static Kind, Error> {
    kinds().find(|kind| kind.name == name).ok_or_else(|| {
        let names: Vec<&str> = kinds().map(|kind| kind.name).collect();
        Error::Input(format!(
            "cases of kind `{name}` are not supported; use one of: {}",
            names.join(", ")
        ))
    })
}

/// A case that there is no room for.
fn left_out(case: &Node) -> CaseReport {
    let reason =
        "not computed: the cases before it reach the limit for one file; split the file".to_owned();
    CaseReport {
        name: inputs::title(case),
        outputs: Err(Error::Input(reason)),
        notes: Vec::new(),
    }
}

/// How many values there are in some outputs. They are nested as deep as the kinds of cases make
/// them.
fn values(outputs: &Map<String, Value>) -> usize {
    let mut open: Vec<&Value> = outputs.values().collect();
    let mut count = 0;
    while let Some(value) = open.pop() {
        count += 1;
        match value {
            Value::Array(elements) => open.extend(elements),
            Value::Object(members) => open.extend(members.values()),
            _ => {}
        }
    }
    count
}

fn report(kind: &Kind, computer: &mut Computer<'_>, case: &Node) -> CaseReport {
    let mut notes = Vec::new();
    let outputs = match (kind.outputs)(computer, case, &mut notes) {
        Err(Error::Stops {
            exception, reason, ..
        }) => {
            notes.push(reason);
            Ok(super::object([("error", Value::from(exception))]))
        }
        other => other,
    };
    CaseReport {
        name: inputs::title(case),
        outputs,
        notes,
    }
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
            if let [_, key, .., last] = case.elements() {
                let of = |name: &str| {
                    outputs
                        .get(name)
                        .cloned()
                        .unwrap_or(Value::Null)
                        .to_string()
                };
                out.extend_from_slice(self.text.get(from..key.span.start).unwrap_or_default());
                out.extend_from_slice(format!("{}, {}", of("key"), of("values")).as_bytes());
                from = last.span.end;
                continue;
            }
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
        let cases = inputs::cases(&self.document.root).iter().zip(&self.reports);
        cases
            .map(|(case, report)| compare::compare(self.kind, case, report))
            .collect()
    }
}
